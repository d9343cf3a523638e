# What Debian wants in another place or form than `cmake --install` leaves it; CPack runs this on the files of a package.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)

# Debian's Python looks in lib/python3.
file(GLOB modules ${root}/lib/python3.*/dist-packages)
foreach(module IN LISTS modules)
  file(MAKE_DIRECTORY ${root}/lib/python3)
  file(RENAME ${module} ${root}/lib/python3/dist-packages)
  cmake_path(GET module PARENT_PATH emptied)
  file(REMOVE_RECURSE ${emptied})
endforeach()

set(documents ${root}/share/doc/scarp)
file(RENAME ${documents}/LICENSE ${documents}/copyright)
file(GLOB man_pages ${root}/share/man/man1/*.1)
if(man_pages)
  # -n: no time of day, so that equal files make equal packages.
  execute_process(COMMAND gzip -9n ${man_pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
