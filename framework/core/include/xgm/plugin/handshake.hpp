// SPDX-License-Identifier: Apache-2.0
// How a plugin file introduces itself: plain C, compared before any C++ crosses.
#pragma once

#include <opencv2/core/version.hpp>

#include "xgm/base/export.hpp"
#include "xgm/plugin/registry.hpp"
#include "xgm/plugin/version.hpp"

extern "C" {
/// Layout fixed for ever: every version of xgm can read the first three members of every plugin.
struct xgm_plugin_handshake {
  unsigned abi;           ///< XGM_PLUGIN_ABI of the SDK it was built with
  const char* build_tag;  ///< XGM_BUILD_TAG likewise
  const char* name;       ///< name of the plugin file's target
  void (*add)(void* registry);
};
}

/// Raised whenever a class of the SDK changes its layout or its virtual functions.
#define XGM_PLUGIN_ABI 7u

#define XGM_TEXT_(x) #x
#define XGM_TEXT(x) XGM_TEXT_(x)

#if defined(__clang__)
#define XGM_COMPILER_TAG "clang " XGM_TEXT(__clang_major__)
#else
#define XGM_COMPILER_TAG "g++ " XGM_TEXT(__GNUC__)
#endif
#if defined(_LIBCPP_VERSION)
#define XGM_STDLIB_TAG "libc++ " XGM_TEXT(_LIBCPP_ABI_VERSION)
#else
#define XGM_STDLIB_TAG "libstdc++ cxx11abi=" XGM_TEXT(_GLIBCXX_USE_CXX11_ABI)
#endif

/// What must be equal on both sides: compiler, standard library, OpenCV, SDK.
#define XGM_BUILD_TAG \
  XGM_COMPILER_TAG    \
  ", " XGM_STDLIB_TAG \
  ", OpenCV " XGM_TEXT(CV_VERSION_MAJOR) "." XGM_TEXT(CV_VERSION_MINOR) ", xgm " XGM_VERSION

/// Opens the function that adds a plugin's stages:  XGM_PLUGIN(registry) { registry.add<...>(...);
/// } Inside the library (XGM_BUILTIN is the function's name) it defines that function; elsewhere it
/// also defines the one C symbol by which the file is loaded (XGM_PLUGIN_NAME comes from the CMake
/// helper).
#if defined(XGM_BUILTIN)
#define XGM_PLUGIN(registry)                   \
  namespace xgm::builtin {                     \
  void XGM_BUILTIN(::xgm::Registry& registry); \
  }                                            \
  void xgm::builtin::XGM_BUILTIN(::xgm::Registry& registry)
#else
#ifndef XGM_PLUGIN_NAME
#define XGM_PLUGIN_NAME "unnamed"
#endif
#define XGM_PLUGIN(registry)                                                           \
  static void xgm_plugin_add(::xgm::Registry& registry);                               \
  extern "C" XGM_API const xgm_plugin_handshake* xgm_plugin() {                        \
    static const xgm_plugin_handshake handshake{                                       \
        XGM_PLUGIN_ABI, XGM_BUILD_TAG, XGM_PLUGIN_NAME,                                \
        [](void* target) { xgm_plugin_add(*static_cast<::xgm::Registry*>(target)); }}; \
    return &handshake;                                                                 \
  }                                                                                    \
  static void xgm_plugin_add(::xgm::Registry& registry)
#endif
