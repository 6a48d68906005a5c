# SPDX-License-Identifier: Apache-2.0
# xgm_add_plugin(<name> SOURCES <file>... [LIBRARIES <target>...])
# Builds the plugin file xgm_<name>.so, to be loaded with --plugin or XGM_PLUGIN_PATH. Nothing but
# the one symbol that XGM_PLUGIN makes is visible, so plugins cannot disturb each other. Where no
# build type is chosen, it is optimised as in Release: plugins go through all pixels.
function(xgm_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 plugin "" "" "SOURCES;LIBRARIES")
  if(NOT plugin_SOURCES OR plugin_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "write xgm_add_plugin(${name} SOURCES file.cpp ... [LIBRARIES target ...])")
  endif()
  add_library(${name} MODULE ${plugin_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_definitions(${name} PRIVATE XGM_PLUGIN_NAME="${name}")
  target_link_libraries(${name} PRIVATE xgm::xgm ${plugin_LIBRARIES})
  set_target_properties(${name} PROPERTIES PREFIX "" OUTPUT_NAME xgm_${name} CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(NOT CMAKE_BUILD_TYPE AND NOT multi_config)
    separate_arguments(release_flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS_RELEASE}")
    target_compile_options(${name} PRIVATE ${release_flags})
  endif()
endfunction()
