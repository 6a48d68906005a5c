// SPDX-License-Identifier: Apache-2.0
// Hamming distances of the base pixels of a row to their candidates: the inner loop of the census
// cost.
#pragma once

#include "plugins/cost/census/transform.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::census {

/// Two rows of descriptors of the same window and 1 or 3 channels, at most 240 bits in all. The
/// match row is mirrored, for ascending disparity walks it backwards: the candidates of a base
/// pixel lie side by side, and exist in memory for every cell that the volume has room for.
struct RowPair {
  const Descriptors& base;
  const Descriptors& match;
  int channels = 1;

  /// Where in the match row the first candidate of a base pixel is.
  static int first(const VolumeShape& shape, int y, int x) {
    return shape.width() - 1 - x + shape.begin(y, x);
  }
};

/// Writes row y of the volume, whole granules: the mean over the channels of the number of
/// different bits, half rounded up, or kNoMatch where the candidate does not exist.
void hamming(const RowPair& rows, int y, CostVolume& costs);

/// The same without vector instructions.
void hamming_plain(const RowPair& rows, int y, CostVolume& costs);

}  // namespace xgm::census
