// SPDX-License-Identifier: Apache-2.0
// A handshake of the right build whose function to add stages is missing.
#include "nothing.hpp"

extern "C" XGM_API const xgm_plugin_handshake* xgm_plugin() {
  static const xgm_plugin_handshake handshake{XGM_PLUGIN_ABI, XGM_BUILD_TAG, "adds_nothing",
                                              nullptr};
  return &handshake;
}
