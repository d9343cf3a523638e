# `cmake --install`: the static library as scarp::engine with its public headers, both programs with their man pages and
# completion, documents, and what the programs read at run time under share/scarp.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -D \"SOURCE=${PROJECT_SOURCE_DIR}\"
  -D \"BINARY=${PROJECT_BINARY_DIR}\"
  -D \"DESTINATION=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\"
  -P \"${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake\" COMMAND_ERROR_IS_FATAL ANY)")

install(TARGETS scarp_engine EXPORT scarpTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS scarp RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET scarp-lammps)
  # A component of its own, which the packages leave out.
  install(TARGETS scarp-lammps RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lammps)
  install(FILES engine/distributed/COPYING DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME COPYING.scarp-lammps COMPONENT lammps)
endif()
if(TARGET scarp-validate)
  install(TARGETS scarp-validate RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

set(scarp_share_patterns FILES_MATCHING
  PATTERN "*.py" PATTERN "*.toml" PATTERN "*.json" PATTERN "*.csv" PATTERN "*.md" PATTERN "*.html"
  PATTERN "*.css" PATTERN "__pycache__" EXCLUDE)
# The programs look for these in share/scarp beside their own bin/ before they look in the sources.
install(DIRECTORY engine/report/ DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp/report ${scarp_share_patterns})
if(TARGET scarp_viewer)
  install(FILES ${scarp_viewer_script} DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp/report OPTIONAL)
  install(FILES ${scarp_viewer_dir}/three.js.LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
endif()
if(TARGET scarp-validate)
  install(DIRECTORY validation/cases DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp/validation
          ${scarp_share_patterns})
  install(FILES validation/report.py validation/overview.py validation/error_time/error_time_page.py
          validation/stability/stability_page.py validation/bishop_figures.py validation/claims_table.py
          validation/column_figures.py validation/slope_figures.py
          DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp/validation)
endif()

# Documents keep their places among each other, so that links between them hold.
file(GLOB_RECURSE scarp_documents RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
  engine/*.md engine/*.ipynb kernels/*.md validation/*.md validation/*.png bench/*.md)
list(FILTER scarp_documents EXCLUDE REGEX node_modules)  # where somebody called npm in engine/viewer
foreach(document IN LISTS scarp_documents ITEMS README.md CHANGELOG.md LICENSE)
  cmake_path(GET document PARENT_PATH folder)
  install(FILES ${document} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
configure_file(CITATION.cff ${PROJECT_BINARY_DIR}/CITATION.cff COPYONLY)
file(APPEND ${PROJECT_BINARY_DIR}/CITATION.cff "version: ${PROJECT_VERSION}\n")
install(FILES ${PROJECT_BINARY_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(help_pages)

set(scarp_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/scarp)
install(EXPORT scarpTargets NAMESPACE scarp:: DESTINATION ${scarp_package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/scarpConfig.cmake.in
  ${PROJECT_BINARY_DIR}/scarpConfig.cmake INSTALL_DESTINATION ${scarp_package_dir})
# Below 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scarpConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scarpConfig.cmake ${PROJECT_BINARY_DIR}/scarpConfigVersion.cmake
        DESTINATION ${scarp_package_dir})

# Last, where it can be read.
if(SCARP_BUILD_PYTHON)
  install(CODE "if(NOT DEFINED ENV{DESTDIR} AND NOT CMAKE_INSTALL_PREFIX MATCHES _CPack_Packages)
  execute_process(COMMAND \"${Python_EXECUTABLE}\" \"${PROJECT_SOURCE_DIR}/engine/python/say_where.py\"
    \"\${CMAKE_INSTALL_PREFIX}/${SCARP_PYTHON_DIR}\")
endif()")
endif()
