# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where beside the rooms (room.cmake): what find_package(xgm) reads.
# Everything is found relative to where it lies, so the folder may be moved.
include(CMakePackageConfigHelpers)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/xgmConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/xgmConfig.cmake INSTALL_DESTINATION ${XGM_CMAKE_FOLDER})
# Before 1.0 a minor version may change the SDK.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/xgmConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/generated/xgmConfig.cmake
  ${PROJECT_BINARY_DIR}/generated/xgmConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/xgm_add_plugin.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindOpenCV.cmake
  DESTINATION ${XGM_CMAKE_FOLDER} COMPONENT core)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm
  RENAME copyright COMPONENT core)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/third_party_notes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm COMPONENT core)
