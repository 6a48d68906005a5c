// SPDX-License-Identifier: Apache-2.0
// Hamming distances of the base pixels of a row to their candidates: the inner loop of the census
// cost.
#pragma once

#include "plugins/cost/census/transform.hpp"

namespace xgm::census {

/// Descriptors of the same window, 1 or 3 channels, at most 255 bits in all.
using RowPair = cost::RowPair<std::uint8_t>;

/// Writes row y of the volume, whole granules: the mean over the channels of the number of
/// different bits, half rounded up, or kNoMatch where the candidate does not exist.
void hamming(const RowPair& rows, int y, CostVolume& costs);

/// The same without vector instructions.
void hamming_plain(const RowPair& rows, int y, CostVolume& costs);

}  // namespace xgm::census
