# The only place with instruction-set flags: one object library per instruction set, each compiling
# the same instantiations. Always optimised, whatever the build type: at -O0 these objects would carry
# weak copies of ordinary inline functions, which the linker could keep for the whole program.
function(scarp_add_isa isa)
  add_library(scarp_kernels_${isa} OBJECT ${PROJECT_SOURCE_DIR}/kernels/isa/${isa}.cpp)
  target_link_libraries(scarp_kernels_${isa} PRIVATE scarp_options xsimd)
  set_target_properties(scarp_kernels_${isa} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # gcc 12 prints false -Wuninitialized out of its AVX-512 headers.
  target_compile_options(scarp_kernels_${isa} PRIVATE ${ARGN} -O3
    $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>)
  if(SCARP_SANITIZE)
    # Instrumented, one of these objects compiles for more than four minutes. What they read and write is
    # checked around them: by the passes' own tests and by the instrumented arrays of the engine.
    set_target_properties(scarp_kernels_${isa} PROPERTIES SCARP_UNINSTRUMENTED ON)
    target_compile_options(scarp_kernels_${isa} PRIVATE -g0)
  endif()
  if(SCARP_KERNEL_SET STREQUAL "smoke")
    target_compile_definitions(scarp_kernels_${isa} PRIVATE SCARP_KERNEL_SET_SMOKE)
  endif()
endfunction()

# The instruction sets of the processor that is built for, best last; which of them a machine has is found out when a
# program starts. Every processor of a family has the first.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(scarp_isas sse2 avx2 avx512)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  set(scarp_isas neon)
else()
  message(FATAL_ERROR "scarp has no kernels for the processor '${CMAKE_SYSTEM_PROCESSOR}', only for x86-64 and 64-bit ARM")
endif()
set(scarp_isa_flags_sse2 -msse2)
set(scarp_isa_flags_avx2 -mavx2 -mfma)
set(scarp_isa_flags_avx512 -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx512vl -mfma -mprefer-vector-width=512)
set(scarp_isa_flags_neon "")
set(scarp_isa_objects)
foreach(isa IN LISTS scarp_isas)
  scarp_add_isa(${isa} ${scarp_isa_flags_${isa}})
  list(APPEND scarp_isa_objects $<TARGET_OBJECTS:scarp_kernels_${isa}>)
endforeach()
