// SPDX-License-Identifier: Apache-2.0
// Hamming distances, a cell at a time: what the kernel's results are measured by.
#include "plugins/cost/census/hamming.hpp"

#include <bit>

namespace xgm::census {
namespace {

std::uint8_t cost(const RowPair& rows, int x, int candidate) {
  if (rows.match.absent()[candidate] != 0) return CostVolume::kNoMatch;
  int bits = 0;
  for (int k = 0; k < rows.base.plane_count(); ++k) {
    const int difference = rows.base.plane(k)[x] ^ rows.match.plane(k)[candidate];
    bits += std::popcount(static_cast<unsigned>(difference));
  }
  return static_cast<std::uint8_t>((2 * bits + rows.channels) / (2 * rows.channels));
}

}  // namespace

void hamming_plain(const RowPair& rows, int y, CostVolume& costs) {
  const VolumeShape& shape = costs.shape();
  for (int x = 0; x < shape.width(); ++x) {
    const int first = RowPair::first(shape, y, x);
    std::uint8_t* const cells = costs.at(y, x);
    for (int i = 0; i < shape.room(y, x); ++i) cells[i] = cost(rows, x, first + i);
  }
}

}  // namespace xgm::census
