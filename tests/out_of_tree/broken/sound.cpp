// SPDX-License-Identifier: Apache-2.0
// Nothing is wrong with this one: it must work beside all the others.
#include "nothing.hpp"

XGM_PLUGIN(registry) { registry.add<Nothing>("sound", "Changes nothing."); }
