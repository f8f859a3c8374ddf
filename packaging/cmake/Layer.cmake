# A layer is a folder of core with all sources below it, those in subfolders included. cullscope_layer(NAME [SOURCES generated
# files] [EXCEPT folder of another target] [LINKS …] [PRIVATE_LINKS …] [QUICK]) makes one static library of it. QUICK: tests
# spend little time in its code, so that in the builds for tests its compilation is not optimised, which takes half as long.
function(cullscope_layer name)
  cmake_parse_arguments(ARG "QUICK" "EXCEPT" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "/${ARG_EXCEPT}")
  endif()
  add_library(cullscope_${name} STATIC ${sources} ${ARG_SOURCES})
  add_library(cullscope::${name} ALIAS cullscope_${name})
  target_compile_options(cullscope_${name} PRIVATE ${CULLSCOPE_CORE_OPTIONS})
  if(ARG_QUICK AND NOT CULLSCOPE_FUZZERS)
    target_compile_options(cullscope_${name} PRIVATE $<$<CONFIG:None>:-O0>)
  endif()
  if(CULLSCOPE_SANITIZE)
    # Without what the address sanitizer tells as well, which costs a quarter of the compilation: accesses through null pointers
    # and beyond an object.
    target_compile_options(cullscope_${name} PRIVATE -fsanitize=undefined -fno-sanitize=null,object-size
      -fno-sanitize-recover=undefined)
  endif()
  target_link_libraries(cullscope_${name} PUBLIC cullscope_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()
