// SPDX-License-Identifier: Apache-2.0
// A plugin file whose handshake is what the target handshake.cpp makes it.
#include "xgm/plugin/handshake.hpp"

extern "C" XGM_API const xgm_plugin_handshake* xgm_plugin() {
  static xgm_plugin_handshake handshake{};
  return &handshake;
}
