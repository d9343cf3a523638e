# `cpack --preset release`: a .tar.gz that runs wherever it is unpacked and, on Debian, a .deb, both in
# build/release/packages.
set(CPACK_PACKAGE_NAME scarp)
set(CPACK_PACKAGE_VENDOR "The scarp authors")
set(CPACK_PACKAGE_CONTACT "The scarp authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Smoothed-particle hydrodynamics for slope failure")
set(CPACK_PACKAGE_DESCRIPTION "scarp follows soil from the stable state through the slide to the new rest, in
plane strain and in three dimensions, and finds factors of safety. The package
holds the programs scarp and scarp-validate, the C++ library, and the Python
module scarp.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_FILE_NAME scarp-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
# One package of all but scarp-lammps, which is under the GPL-2 and would bring MPI and LAMMPS along.
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};scarp;Unspecified;/")

set(CPACK_GENERATOR TGZ)
# CPack asks them which libraries the programs need; without an answer the .deb would depend on nothing.
find_program(SCARP_DPKG_SHLIBDEPS dpkg-shlibdeps)
find_program(SCARP_FILE_UTILITY file)
if(SCARP_DPKG_SHLIBDEPS AND SCARP_FILE_UTILITY)
  list(APPEND CPACK_GENERATOR DEB)
else()
  message(STATUS "CPack makes no .deb: it needs Debian's dpkg-dev and file")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package_for_debian.cmake)
if(SCARP_BUILD_PYTHON)
  # The module is built for this Python alone.
  math(EXPR scarp_next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~), \
python3 (<< ${Python_VERSION_MAJOR}.${scarp_next_python}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib, python3-h5py")  # reports, read_frames()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libhdf5-dev, zlib1g-dev, libfmt-dev, libtomlplusplus-dev, libmuparser-dev, \
python3-pandas, paraview")
include(CPack)
