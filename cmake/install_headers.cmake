# Installs the public headers under their public names, with their includes of one another rewritten.
# cmake -D SOURCE=... -D BINARY=... -D DESTINATION=... -P install_headers.cmake
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
foreach(header IN LISTS scarp_public_headers)
  scarp_public_name(${header} name)
  file(READ ${SOURCE}/${header} text)
  string(REGEX REPLACE "#include \"(engine/)?([^\"]+)\"" "#include \"scarp/\\2\"" text "${text}")
  file(WRITE ${DESTINATION}/scarp/${name} "${text}")
endforeach()
file(COPY ${BINARY}/include/scarp/version.hpp DESTINATION ${DESTINATION}/scarp)
