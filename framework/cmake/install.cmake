# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where: the library, the SDK's headers, and what find_package(xgm)
# reads. Everything is found relative to where it lies, so the folder may be moved.
include(CMakePackageConfigHelpers)
set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/xgm)
install(TARGETS xgm EXPORT xgmTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT xgmTargets NAMESPACE xgm:: DESTINATION ${cmake_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework/include/xgm
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/xgmConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/xgmConfig.cmake INSTALL_DESTINATION ${cmake_folder})
# Before 1.0 a minor version may change the SDK.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/xgmConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/generated/xgmConfig.cmake
  ${PROJECT_BINARY_DIR}/generated/xgmConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/xgm_add_plugin.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindOpenCV.cmake
  DESTINATION ${cmake_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm
  RENAME copyright)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/third_party_notes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/xgm)
