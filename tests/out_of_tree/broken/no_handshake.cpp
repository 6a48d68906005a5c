// SPDX-License-Identifier: Apache-2.0
// Has the symbol, but nothing behind it.
#include "nothing.hpp"

extern "C" XGM_API const xgm_plugin_handshake* xgm_plugin() { return nullptr; }
