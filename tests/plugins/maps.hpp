// SPDX-License-Identifier: Apache-2.0
// Disparity maps and images for tests of stages that work on maps.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/support.hpp"

namespace xgm::testing {

/// Sizes at which windows are cut off on every side, one at which some are not, and one wider than
/// several vectors.
inline const std::vector<cv::Size> kMapSizes{{1, 1},  {1, 9},   {9, 1},  {2, 2},
                                             {13, 8}, {31, 22}, {150, 5}};

struct MapRecipe {
  double lowest = 0, highest = 20;  ///< disparities drawn from [lowest, highest]
  double step = 1;                  ///< disparities are multiples of this
  double invalid_share = 0.3;       ///< of the pixels; each of another invalid status
};

inline DisparityMap random_map(cv::Size size, const MapRecipe& recipe, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Status> reasons{Status::masked,   Status::out_of_range, Status::ambiguous,
                                    Status::occluded, Status::mismatched,   Status::peak};
  DisparityMap map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int step =
          random.integer(0, static_cast<int>((recipe.highest - recipe.lowest) / recipe.step));
      const double value = recipe.lowest + recipe.step * step;
      const bool invalid = random.real(0, 1) < recipe.invalid_share;
      const std::uint64_t kind = random.next();
      if (invalid) {
        map.invalidate(y, x, reasons[kind % reasons.size()]);
      } else {
        map.set(y, x, static_cast<float>(value), kind % 8 == 0 ? Status::filled : Status::matched);
      }
    }
  }
  return map;
}

/// Grey levels alike enough for colour weights that are neither 0 nor 1; `planes` planes.
inline ImagePair random_guide(cv::Size size, int planes, std::uint64_t seed) {
  Random random(seed);
  Image image;
  for (int plane = 0; plane < planes; ++plane) {
    cv::Mat1f levels(size);
    for (float& level : levels) level = static_cast<float>(random.integer(100, 130));
    image.planes.push_back(levels);
  }
  return {image, image};
}

inline bool is_consistent(const DisparityMap& map) {
  if (map.disparity.size() != map.status.size()) return false;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (std::isfinite(map.disparity(y, x)) != map.has_disparity(y, x)) return false;
    }
  }
  return true;
}

/// Letters to a map: digits are disparities; '.' occluded, 'x' mismatched, '#' masked, '?'
/// ambiguous.
inline DisparityMap drawn_map(const std::vector<std::string>& rows) {
  DisparityMap map(cv::Size(static_cast<int>(rows.front().size()), static_cast<int>(rows.size())));
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      if (c == '.') map.invalidate(y, x, Status::occluded);
      if (c == 'x') map.invalidate(y, x, Status::mismatched);
      if (c == '#') map.invalidate(y, x, Status::masked);
      if (c == '?') map.invalidate(y, x, Status::ambiguous);
      if (c >= '0' && c <= '9') map.set(y, x, static_cast<float>(c - '0'));
    }
  }
  return map;
}

}  // namespace xgm::testing
