// SPDX-License-Identifier: Apache-2.0
// What all fusers share: maps made by choosing a candidate for each pixel.
#pragma once

#include "xgm/base/parallel.hpp"
#include "xgm/stage/fuser.hpp"

namespace xgm::fuser {

/// No candidate has a disparity at the pixel.
constexpr int kNone = -1;

/// The first candidate that has a disparity at the pixel, or kNone.
inline int first_with_disparity(const Candidates& candidates, int y, int x) {
  for (std::size_t i = 0; i < candidates.maps.size(); ++i) {
    if (candidates.maps[i].has_disparity(y, x)) return static_cast<int>(i);
  }
  return kNone;
}

/// Takes at each pixel what candidate choose(y, x) has there. Pixels of kNone have no disparity,
/// for the reason that the first candidate tells. Rows are chosen in parallel.
template <class Choose>
DisparityMap chosen(const Candidates& candidates, const Choose& choose) {
  DisparityMap map = candidates.maps.front().clone();
  map.confidence.release();
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      const int choice = choose(y, x);
      if (choice == kNone) continue;
      const DisparityMap& from = candidates.maps[static_cast<std::size_t>(choice)];
      map.set(y, x, from.disparity(y, x), from.at(y, x));
    }
  });
  return map;
}

}  // namespace xgm::fuser
