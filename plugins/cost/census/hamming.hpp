// SPDX-License-Identifier: Apache-2.0
// Hamming distances of one base pixel to its candidates: the inner loop of the census cost.
#pragma once

#include "plugins/cost/census/transform.hpp"
#include "plugins/cost/shared/candidates.hpp"

namespace xgm::census {

/// Writes the mean over the channels of the number of different bits, half rounded up.
/// Both rows have the same window and 1 or 3 channels; at most 256 bits in all.
void hamming(const Descriptors& base, const Descriptors& mirrored_match,
             const cost::Candidates& candidates);

}  // namespace xgm::census
