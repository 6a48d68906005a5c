// SPDX-License-Identifier: Apache-2.0
// A shared object that is not a plugin: XGM_PLUGIN is missing.
#include "nothing.hpp"

extern "C" XGM_API int answer();
int answer() { return static_cast<int>(sizeof(Nothing)); }
