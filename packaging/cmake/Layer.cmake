# cullscope_layer(NAME SOURCES … LINKS …): one static library a folder of core, with the project's options and a
# precompiled header of the standard library and GLM.
function(cullscope_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(cullscope_${name} STATIC ${ARG_SOURCES})
  add_library(cullscope::${name} ALIAS cullscope_${name})
  target_link_libraries(cullscope_${name} PUBLIC cullscope_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  target_precompile_headers(cullscope_${name} PRIVATE ${CMAKE_SOURCE_DIR}/core/precompiled.h)
endfunction()
