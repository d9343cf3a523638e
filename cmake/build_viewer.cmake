# cmake -D NPM=npm -D SOURCE=engine/viewer -D WORK=folder -D ALSO=folder -P build_viewer.cmake: WORK/scarp_viewer.js, the licence of
# three.js that it carries, and a copy in ALSO, where the Python module finds it. npm works in a copy, so that the sources stay as
# they are. Where npm cannot fetch what it needs, the build goes on without the script.
file(MAKE_DIRECTORY ${WORK}/src ${ALSO})
foreach(pattern package.json package-lock.json .npmrc build.mjs src)
  file(COPY ${SOURCE}/${pattern} DESTINATION ${WORK})
endforeach()

# What is fetched stays until the list of it changes.
file(READ ${WORK}/package-lock.json wanted)
set(fetched "")
if(EXISTS ${WORK}/fetched.json)
  file(READ ${WORK}/fetched.json fetched)
endif()
if(NOT wanted STREQUAL fetched)
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 WORKING_DIRECTORY ${WORK}
                  RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    file(REMOVE ${WORK}/scarp_viewer.js ${ALSO}/scarp_viewer.js ${WORK}/fetched.json)
    message(WARNING "Reports are built without their moving picture: npm, which needs a network once, could not fetch three.js and "
                    "esbuild. To try again, build again.\n${said}")
    return()
  endif()
  file(COPY_FILE ${WORK}/package-lock.json ${WORK}/fetched.json)
endif()

execute_process(COMMAND ${NPM} run --silent build -- ${WORK}/scarp_viewer.js WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE ${WORK}/scarp_viewer.js ${ALSO}/scarp_viewer.js)
file(COPY_FILE ${WORK}/node_modules/three/LICENSE ${WORK}/three.js.LICENSE)
