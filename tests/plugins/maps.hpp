// SPDX-License-Identifier: Apache-2.0
// Disparity maps and images for tests of stages that work on maps.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"

namespace xgm::testing {

/// Sizes at which windows are cut off on every side, and one that is none.
inline const std::vector<cv::Size> kMapSizes{{1, 1}, {1, 9}, {9, 1}, {2, 2}, {13, 8}, {31, 22}};

struct MapRecipe {
  double lowest = 0, highest = 20;  ///< disparities drawn from [lowest, highest]
  double step = 1;                  ///< disparities are multiples of this
  double invalid_share = 0.3;       ///< of the pixels; each of another invalid status
};

inline double uniform(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.0;  // the same numbers on every platform
}

inline DisparityMap random_map(cv::Size size, const MapRecipe& recipe, std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::vector<Status> reasons{Status::masked,   Status::out_of_range, Status::ambiguous,
                                    Status::occluded, Status::mismatched,   Status::peak};
  DisparityMap map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double steps = std::floor((recipe.highest - recipe.lowest) / recipe.step + 1);
      const double value = recipe.lowest + recipe.step * std::floor(uniform(random) * steps);
      const bool invalid = uniform(random) < recipe.invalid_share;
      const std::uint32_t kind = random();
      if (invalid) {
        map.invalidate(y, x, reasons[kind % reasons.size()]);
      } else {
        map.set(y, x, static_cast<float>(value), kind % 8 == 0 ? Status::filled : Status::valid);
      }
    }
  }
  return map;
}

/// Grey levels 0 to 255 in `planes` planes; neighbours are alike so that colour weights matter.
inline ImagePair random_guide(cv::Size size, int planes, std::uint32_t seed) {
  std::mt19937 random(seed);
  Image image;
  for (int plane = 0; plane < planes; ++plane) {
    cv::Mat1f levels(size);
    for (float& level : levels) level = static_cast<float>(100 + random() % 30);
    image.planes.push_back(levels);
  }
  return {image, image};
}

inline bool is_consistent(const DisparityMap& map) {
  if (map.disparity.size() != map.status.size()) return false;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (std::isfinite(map.disparity(y, x)) != map.valid(y, x)) return false;
    }
  }
  return true;
}

/// Equal bit for bit, NaN equal to NaN.
inline bool identical(const DisparityMap& a, const DisparityMap& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.size().height; ++y) {
    for (int x = 0; x < a.size().width; ++x) {
      if (a.at(y, x) != b.at(y, x)) return false;
      if (a.valid(y, x) && a.disparity(y, x) != b.disparity(y, x)) return false;
    }
  }
  return is_consistent(a) && is_consistent(b);
}

/// Letters to a map: digits are disparities; '.' occluded, 'x' mismatched, '#' masked, '?' ambiguous.
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
