// SPDX-License-Identifier: Apache-2.0
// Throws what is no std::exception.
#include "nothing.hpp"

XGM_PLUGIN(registry) {
  registry.add<Nothing>("counted", "Changes nothing.");
  throw 42;
}
