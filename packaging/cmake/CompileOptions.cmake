# Linked by every target of the project: warnings are errors, and floating-point arithmetic is not contracted, so that a SIMD path
# can be bit-identical to its scalar one.
add_library(cullscope_options INTERFACE)
target_compile_options(cullscope_options INTERFACE
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>  # in a unity build GCC reports for sources what is meant for headers
  # GCC collects garbage once 128 MB are in use, which a unity is from its headers on; up to 2 GB it costs time and saves nothing.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>
  -Wall -Wextra -Wpedantic -Werror -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -ffp-contract=off)
target_include_directories(cullscope_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_definitions(cullscope_options INTERFACE
  CULLSCOPE_VERSION="${PROJECT_VERSION}" GLM_FORCE_XYZW_ONLY GLM_FORCE_EXPLICIT_CTOR)

if(CULLSCOPE_SANITIZE)
  # The layers of core have the undefined-behaviour sanitizer besides (Layer.cmake): in the tests' own code it would take a third
  # of their compilation.
  target_compile_options(cullscope_options INTERFACE -fsanitize=address -fno-omit-frame-pointer)
  target_link_options(cullscope_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(cullscope_options INTERFACE CULLSCOPE_SANITIZED)
endif()

if(CULLSCOPE_FUZZERS)
  # libFuzzer steers by what the code counts of its branches and compares.
  target_compile_options(cullscope_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# A change of the library links every program that has it: lld takes a seventh of the usual linker's time. Without it nothing
# else changes.
find_program(CULLSCOPE_LLD ld.lld)
if(CULLSCOPE_LLD)
  target_link_options(cullscope_options INTERFACE -fuse-ld=lld)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  # Precompiled headers need these two relaxations, or ccache does not find them again.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

# by_second_compiler(TARGET): compiles a target of the tests with Clang in a build with GCC, in two fifths of its time. What is
# delivered stays with GCC, and the library is compiled by both (preset asan). Without Clang nothing changes.
find_program(CULLSCOPE_SECOND_COMPILER clang++-14)
function(by_second_compiler target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CULLSCOPE_SECOND_COMPILER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_SOURCE_DIR}/packaging/cmake/second-compiler;${CMAKE_CXX_COMPILER};${CULLSCOPE_SECOND_COMPILER};${CMAKE_CXX_COMPILER_LAUNCHER}")
  endif()
endfunction()
