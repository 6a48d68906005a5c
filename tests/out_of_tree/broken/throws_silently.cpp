// SPDX-License-Identifier: Apache-2.0
// Fails half-way, with an exception that does not say why.
#include <stdexcept>

#include "nothing.hpp"

XGM_PLUGIN(registry) {
  registry.add<Nothing>("before_silence", "Changes nothing.");
  throw std::runtime_error("");
}
