// SPDX-License-Identifier: Apache-2.0
// Fails half-way through its registration; what it had added must not stay.
#include <stdexcept>

#include "nothing.hpp"

XGM_PLUGIN(registry) {
  registry.add<Nothing>("half_way", "Changes nothing.");
  throw std::runtime_error("no licence for this machine");
}
