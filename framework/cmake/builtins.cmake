# SPDX-License-Identifier: Apache-2.0
# Finds the plugins of the tree and writes the list of built-ins: one folder plugins/<kind>/<name>
# with a <name>.cpp is one plugin; dropping a folder in is enough. Sets XGM_PLUGIN_SOURCES.
file(GLOB plugin_mains CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/plugins/*/*/*.cpp)
set(XGM_PLUGIN_SOURCES ${plugin_mains})
set(declarations "")
set(calls "")
foreach(source IN LISTS plugin_mains)
  get_filename_component(folder ${source} DIRECTORY)
  get_filename_component(name ${folder} NAME)
  get_filename_component(stem ${source} NAME_WE)
  if(stem STREQUAL name)
    get_filename_component(kind_folder ${folder} DIRECTORY)
    get_filename_component(kind ${kind_folder} NAME)
    set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS XGM_BUILTIN=${kind}_${name})
    string(APPEND declarations "void ${kind}_${name}(Registry&);\n")
    string(APPEND calls "  ${kind}_${name}(registry);\n")
  endif()
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/builtins.cpp CONTENT
"// Generated from the folders below plugins/.
#include \"xgm/plugin/registry.hpp\"

namespace xgm::builtin {
${declarations}
void add_all(Registry& registry) {
${calls}}
}  // namespace xgm::builtin
")
