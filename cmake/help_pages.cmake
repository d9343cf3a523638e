# Man page and bash completion of each program, made by help_pages.py from what it says to --help whenever it is built anew.
# Installing needs them, so they belong to `all`. Nobody installs programs with sanitizers.
if(SCARP_SANITIZE)
  return()
endif()
find_program(SCARP_PAGES_PYTHON NAMES python3 PATHS /usr/bin)
if(NOT SCARP_PAGES_PYTHON)
  message(STATUS "Man pages and bash completion are left out: making them needs Debian's python3")
  return()
endif()

set(scarp_pages_dir ${PROJECT_BINARY_DIR}/pages)
set(scarp_pages)
foreach(program scarp scarp-validate)
  if(TARGET ${program})
    set(man ${scarp_pages_dir}/man1/${program}.1)
    set(completion ${scarp_pages_dir}/completions/${program})
    add_custom_command(OUTPUT ${man} ${completion}
      COMMAND ${SCARP_PAGES_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/help_pages.py
              $<TARGET_FILE:${program}> ${PROJECT_VERSION} ${man} ${completion}
      DEPENDS ${program} ${PROJECT_SOURCE_DIR}/cmake/help_pages.py
      COMMENT "Man page and bash completion of ${program}" VERBATIM)
    list(APPEND scarp_pages ${man} ${completion})
    install(FILES ${man} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  endif()
endforeach()
add_custom_target(scarp_pages ALL DEPENDS ${scarp_pages})
