# SPDX-License-Identifier: Apache-2.0
# What find_package(xgm) reads beside the rooms' own files (room.cmake): in the build tree, and where
# `cmake --install` puts it. What is installed is found relative to where it lies, so the folder may
# be moved.
include(CMakePackageConfigHelpers)
get_property(XGM_ROOMS GLOBAL PROPERTY XGM_ROOMS)
get_property(XGM_ROOM_NEEDS GLOBAL PROPERTY XGM_ROOM_NEEDS)
set(package_folder ${PROJECT_BINARY_DIR}/${XGM_CMAKE_FOLDER})
configure_file(${CMAKE_CURRENT_LIST_DIR}/xgmConfig.cmake.in ${package_folder}/xgmConfig.cmake @ONLY)
# Before 1.0 a minor version may change the SDK.
write_basic_package_version_file(${package_folder}/xgmConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
set(package_files ${package_folder}/xgmConfig.cmake ${package_folder}/xgmConfigVersion.cmake)
foreach(helper xgm_add_plugin.cmake FindOpenCV.cmake)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${helper} ${package_folder}/${helper} COPYONLY)
  list(APPEND package_files ${package_folder}/${helper})
endforeach()
install(FILES ${package_files} DESTINATION ${XGM_CMAKE_FOLDER} COMPONENT core)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm
  RENAME copyright COMPONENT core)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/third_party_notes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm COMPONENT core)
