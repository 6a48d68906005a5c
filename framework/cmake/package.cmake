# SPDX-License-Identifier: Apache-2.0
# `cpack -G DEB` in the build folder makes one Debian package: program, library, pipelines and SDK.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "xgm")
set(CPACK_PACKAGE_CONTACT "the xgm authors <xgm@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Run-time dependencies are read from the binaries; building a plugin also needs OpenCV's headers.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, libopencv-core-dev")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
include(CPack)
