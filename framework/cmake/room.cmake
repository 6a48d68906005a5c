# SPDX-License-Identifier: Apache-2.0
# xgm_add_room(<target> COMPONENT <name> [SOURCES <file>...] [NEEDS <room>...] [LIBRARIES <target>...]
#              [PRECOMPILE <header>...] [HARDLY_OPTIMISED <glob>...])
# A room is a shared library of all sources below src/, with its public headers below include/. It is
# installed as a component of its own: find_package(xgm COMPONENTS <name>) gives xgm::<name>.
# NEEDS are the targets of rooms that were added before. HARDLY_OPTIMISED are files in which runs spend
# no time, such as those that read declarations and write text: building them would take most.
set(XGM_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/xgm)
function(xgm_add_room target)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "COMPONENT" "SOURCES;NEEDS;LIBRARIES;PRECOMPILE;HARDLY_OPTIMISED")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp)
  add_library(${target} SHARED ${sources} ${room_SOURCES})
  add_library(xgm::${room_COMPONENT} ALIAS ${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target}
    PUBLIC opencv_core ${room_NEEDS}
    PRIVATE $<BUILD_INTERFACE:xgm_options> ${room_LIBRARIES})
  xgm_precompile(${target} ${room_PRECOMPILE})
  if(room_HARDLY_OPTIMISED)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${room_HARDLY_OPTIMISED})
    set_property(SOURCE ${files} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
  endif()
  # Before 1.0 a minor version may change the binary interface. Libraries lie side by side.
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room_COMPONENT}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN")
  install(TARGETS ${target} EXPORT ${target}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${room_COMPONENT})
  install(EXPORT ${target} NAMESPACE xgm:: FILE xgm_${room_COMPONENT}.cmake
    DESTINATION ${XGM_CMAKE_FOLDER} COMPONENT ${room_COMPONENT})
  export(EXPORT ${target} NAMESPACE xgm::
    FILE ${PROJECT_BINARY_DIR}/${XGM_CMAKE_FOLDER}/xgm_${room_COMPONENT}.cmake)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/xgm COMPONENT ${room_COMPONENT}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
  # For xgmConfig.cmake.
  set(needs "")
  foreach(need IN LISTS room_NEEDS)
    get_target_property(component ${need} EXPORT_NAME)
    list(APPEND needs ${component})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY XGM_ROOMS ${room_COMPONENT})
  set_property(GLOBAL APPEND_STRING PROPERTY XGM_ROOM_NEEDS
    "set(xgm_needs_${room_COMPONENT} ${needs})\n")
endfunction()
