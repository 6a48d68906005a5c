// SPDX-License-Identifier: Apache-2.0
// The Python package, as far as it is there.
#pragma once

#include "xgm/pipeline/health.hpp"

namespace xgm::cli {

/// Asks python3 for the package xgm.
Finding python_package();

}  // namespace xgm::cli
