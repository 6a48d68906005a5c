// SPDX-License-Identifier: Apache-2.0
// Walking over the cells of volumes, for the contract checks.
#pragma once

#include <algorithm>
#include <memory>

#include "contract_support.hpp"

namespace xgm::testing::detail {

inline VolumeShapePtr shape_of(const DisparityRange& range, const cv::Mat1b& valid) {
  return std::make_shared<const VolumeShape>(range, valid);
}

/// Calls body(y, x, d, i) for every cell, i counting within the pixel.
template <class Body>
void each_cell(const VolumeShape& shape, const Body& body) {
  for (int y = 0; y < shape.height(); ++y)
    for (int x = 0; x < shape.width(); ++x)
      for (int i = 0; i < shape.count(y, x); ++i) body(y, x, shape.begin(y, x) + i, i);
}

/// The smallest sum of a pixel, kNoMatch if it has none.
inline int smallest(const AggregatedVolume& sums, int y, int x) {
  int minimum = AggregatedVolume::kNoMatch;
  for (int i = 0; i < sums.shape().count(y, x); ++i)
    minimum = std::min<int>(minimum, sums.at(y, x)[i]);
  return minimum;
}

}  // namespace xgm::testing::detail
