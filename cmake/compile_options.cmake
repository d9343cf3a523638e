# Options shared by every target of the project, through the interface target scarp_options.
add_library(scarp_options INTERFACE)
target_compile_features(scarp_options INTERFACE cxx_std_20)
target_include_directories(scarp_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
target_compile_options(scarp_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=fast
  $<$<BOOL:${SCARP_WARNINGS_AS_ERRORS}>:-Werror>)
if(SCARP_SANITIZE)
  # Without no-recover the undefined-behaviour sanitizer prints and the test passes.
  target_compile_options(scarp_options INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:SCARP_UNINSTRUMENTED>>>:-fsanitize=${SCARP_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all>")
  # gcc 12 prints false -Wmaybe-uninitialized out of its own headers once they are instrumented.
  target_compile_options(scarp_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(scarp_options INTERFACE -fsanitize=${SCARP_SANITIZE})
  # Some tests look at memory, of which this one keeps much for itself.
  if(SCARP_SANITIZE MATCHES address)
    target_compile_definitions(scarp_options INTERFACE SCARP_ADDRESS_SANITIZER)
  endif()
endif()
