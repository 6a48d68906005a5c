// SPDX-License-Identifier: Apache-2.0
// What decides of the files of a cell.
#pragma once

#include <string>

#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// All that decides what a cell's run gives, as JSON.
std::string cell_identity(const BenchRequest& request, std::size_t pipeline, std::size_t scene);

}  // namespace xgm
