// SPDX-License-Identifier: Apache-2.0
// Registers one name twice.
#include "nothing.hpp"

XGM_PLUGIN(registry) {
  registry.add<Nothing>("twin", "Changes nothing.");
  registry.add<Nothing>("twin", "Changes nothing.");
}
