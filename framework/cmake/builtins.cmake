# SPDX-License-Identifier: Apache-2.0
# xgm_add_builtins(<target> <name> KINDS <folder>...)
# Compiles the plugins of the tree into a room: one folder plugins/<kind>/<name> with a <name>.cpp is
# one plugin; dropping a folder in is enough. Generates void xgm::builtin::add_<name>(Registry&), which
# adds them. Folders are <kind>, for all plugins of it, or <kind>/<name>.
function(xgm_add_builtins target function)
  cmake_parse_arguments(PARSE_ARGV 2 builtin "" "" "KINDS")
  set(plugin_sources "")
  foreach(folder IN LISTS builtin_KINDS)
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/plugins/${folder}/*.cpp
      ${PROJECT_SOURCE_DIR}/plugins/${folder}/*/*.cpp)
    list(APPEND plugin_sources ${found})
  endforeach()
  set(declarations "")
  set(calls "")
  foreach(source IN LISTS plugin_sources)
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(name ${folder} NAME)
    get_filename_component(stem ${source} NAME_WE)
    if(stem STREQUAL name)
      get_filename_component(kind_folder ${folder} DIRECTORY)
      get_filename_component(kind ${kind_folder} NAME)
      set_property(SOURCE ${source} TARGET_DIRECTORY ${target} APPEND PROPERTY
        COMPILE_DEFINITIONS XGM_BUILTIN=${kind}_${name})
      string(APPEND declarations "void ${kind}_${name}(Registry&);\n")
      string(APPEND calls "  ${kind}_${name}(registry);\n")
    endif()
  endforeach()
  set(list ${PROJECT_BINARY_DIR}/generated/${function}_plugins.cpp)
  file(CONFIGURE OUTPUT ${list} CONTENT
"// Generated from the folders below plugins/.
#include \"xgm/plugin/registry.hpp\"

namespace xgm::builtin {
${declarations}
void add_${function}(Registry& registry) {
${calls}}
}  // namespace xgm::builtin
")
  target_sources(${target} PRIVATE ${plugin_sources} ${list})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
