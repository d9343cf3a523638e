# The pages as a site, where Debian's python3-sphinx, python3-myst-parser and furo are there:
# cmake --build build/release --target site leaves build/release/site/index.html.
find_program(SCARP_SPHINX sphinx-build PATHS /usr/bin NO_DEFAULT_PATH)
if(PROJECT_IS_TOP_LEVEL AND SCARP_SPHINX)
  add_custom_target(site
    COMMAND ${SCARP_SPHINX} -q -W --keep-going -c ${PROJECT_SOURCE_DIR}/cmake/site ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/site
    COMMENT "Site of the pages in ${PROJECT_BINARY_DIR}/site" VERBATIM)
endif()
