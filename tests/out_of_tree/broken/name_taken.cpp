// SPDX-License-Identifier: Apache-2.0
// Registers a filter that the test's registry has already, and one that nobody has.
#include "nothing.hpp"

XGM_PLUGIN(registry) {
  registry.add<Nothing>("beside_taken", "Changes nothing.");
  registry.add<Nothing>("fake_filter", "Changes nothing.");
}
