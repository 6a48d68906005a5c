// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {

/// Throws Error if a value is out of its range.
void check(const Faults& faults);

}  // namespace xgm::synthesis
