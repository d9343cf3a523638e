# Installs scarp into a fresh folder, then uses that folder alone, as an outside project would.
# cmake -D SCARP_BUILD=... -D WORK=... -D COMPILER=... [-D GENERATOR=...] -P run_embed.cmake
cmake_minimum_required(VERSION 3.25)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${SCARP_BUILD} --prefix ${prefix})

# What is needed only to build scarp must not be asked of its users.
file(GLOB_RECURSE exports ${prefix}/scarp*Targets*.cmake)
if(NOT exports)
  message(FATAL_ERROR "no scarpTargets.cmake was installed under ${prefix}")
endif()
foreach(export IN LISTS exports)
  file(STRINGS ${export} leaks REGEX "xsimd|xtl|Eigen|nlohmann|CLI11|scarp_options|${SCARP_SOURCE}/(engine|kernels|build)")
  if(leaks)
    message(FATAL_ERROR "${export} names what stays inside scarp: ${leaks}")
  endif()
endforeach()

# Every public header stands on its own, with nothing but the installed folder to look into.
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*)
if(NOT "scarp/scarp.hpp" IN_LIST headers)
  message(FATAL_ERROR "scarp/scarp.hpp was not installed under ${prefix}/include")
endif()
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^scarp/")
    message(FATAL_ERROR "${header} was installed outside include/scarp")
  endif()
  file(WRITE ${WORK}/one_header.cpp "#include <${header}>\n")
  run(${COMPILER} -std=c++20 -fsyntax-only -I${prefix}/include ${WORK}/one_header.cpp)
endforeach()

run(${prefix}/bin/scarp --help)
if(NOT EXISTS ${prefix}/share/scarp/report/scarp_report.py)
  message(FATAL_ERROR "the script of `scarp report` was not installed under ${prefix}/share/scarp/report")
endif()
if(EXISTS ${SCARP_BUILD}/bin/scarp-validate)
  run(${prefix}/bin/scarp-validate list)
endif()

# The Python module where it was built: complete, and by itself.
if(EXISTS ${SCARP_BUILD}/python/scarp)
  file(GLOB module ${prefix}/lib/python3*/dist-packages/scarp/_core*.so)
  if(NOT module)
    message(FATAL_ERROR "the Python module was built, but not installed under ${prefix}/lib/python3*")
  endif()
  string(REGEX REPLACE "/scarp/_core[^/]*$" "" packages ${module})
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${packages} ${PYTHON} -c
      "import scarp, scarp.run_files; assert scarp.__file__.startswith('${packages}'), scarp.__file__")
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-on-failure --no-tests=error)
message(STATUS "${output}")
