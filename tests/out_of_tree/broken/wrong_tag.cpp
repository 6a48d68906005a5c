// SPDX-License-Identifier: Apache-2.0
// Built with another compiler, whose name would spoil a message of one line. Calling it would be a
// mistake, so it ends the process.
#include <cstdlib>

#include "nothing.hpp"

extern "C" XGM_API const xgm_plugin_handshake* xgm_plugin() {
  static const xgm_plugin_handshake handshake{XGM_PLUGIN_ABI, "another\ncompiler", XGM_PLUGIN_NAME,
                                              [](void*) { std::abort(); }};
  return &handshake;
}
