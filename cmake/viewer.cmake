# The script of the moving picture in reports: engine/viewer bundled with three.js by npm and esbuild. The build goes on without
# it where there is no npm, or no network the first time; then reports say so.
find_program(SCARP_NPM npm)
option(SCARP_BUILD_VIEWER "Build the moving picture of reports" ON)
if(NOT SCARP_BUILD_VIEWER OR SCARP_SANITIZE)
  return()
endif()
if(NOT SCARP_NPM)
  message(STATUS "Reports are built without their moving picture: it needs npm (Debian's nodejs and npm)")
  return()
endif()
set(scarp_viewer_dir ${PROJECT_BINARY_DIR}/viewer)
set(scarp_viewer_script ${scarp_viewer_dir}/scarp_viewer.js)
file(GLOB scarp_viewer_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/engine/viewer/src/* ${PROJECT_SOURCE_DIR}/engine/viewer/*.json
     ${PROJECT_SOURCE_DIR}/engine/viewer/*.mjs ${PROJECT_SOURCE_DIR}/engine/viewer/.npmrc)
add_custom_command(OUTPUT ${scarp_viewer_script}
  COMMAND ${CMAKE_COMMAND} -D NPM=${SCARP_NPM} -D SOURCE=${PROJECT_SOURCE_DIR}/engine/viewer -D WORK=${scarp_viewer_dir}
          -D ALSO=${PROJECT_BINARY_DIR}/python/scarp
          -P ${PROJECT_SOURCE_DIR}/cmake/build_viewer.cmake
  DEPENDS ${scarp_viewer_sources} ${PROJECT_SOURCE_DIR}/cmake/build_viewer.cmake
  COMMENT "The moving picture of reports" VERBATIM)
add_custom_target(scarp_viewer ALL DEPENDS ${scarp_viewer_script})
