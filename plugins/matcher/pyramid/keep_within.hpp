// SPDX-License-Identifier: Apache-2.0
// Holds what a search_range stage proposes to what the user allows.
#pragma once

#include "xgm/data/disparity_range.hpp"

namespace xgm::pyramid {

/// The pixels' intervals intersected with their limits, of the same size. Where the two do not
/// meet, the coarser level was wrong about this pixel, and its limits are searched. Empty intervals
/// and empty limits stay empty.
DisparityRange keep_within(const DisparityRange& limits, const DisparityRange& proposed);

}  // namespace xgm::pyramid
