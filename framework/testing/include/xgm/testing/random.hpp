// SPDX-License-Identifier: Apache-2.0
// Random numbers for tests: those of xgm/base/random.hpp.
#pragma once

#include "xgm/base/random.hpp"

namespace xgm::testing {

using xgm::Random;

}  // namespace xgm::testing
