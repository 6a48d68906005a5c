// SPDX-License-Identifier: Apache-2.0
#include "plugins/pointing/tie_points/search.hpp"

#include <algorithm>

namespace xgm::geo {

void describe(TieSearch& search, ParameterSet& set) {
  set.add("max_offset", search.max_offset, "Largest pointing error across the epipolar lines.")
      .unit("px")
      .range(0.5, 1000);
  set.add("window", search.window, "Side of the windows in which key points are looked for.")
      .unit("px")
      .range(100, 4000);
  set.add("windows", search.windows, "In each direction of an image, at most.").range(1, 50);
}

std::vector<KeypointMatch> find_ties(const SatelliteImage& base, const SatelliteImage& match,
                                     const HeightInterval& heights, const TieSearch& search) {
  std::vector<KeypointMatch> all;
  // Rounded: of sides that are a little longer than a window, two would show the same twice.
  const auto count = [&](int length) {
    return std::clamp((length + search.window / 2) / search.window, 1, search.windows);
  };
  const int columns = count(base.size.width), rows = count(base.size.height);
  const cv::Size size(std::min(search.window, base.size.width),
                      std::min(search.window, base.size.height));
  const auto at = [](int i, int n, int room) { return n > 1 ? room * i / (n - 1) : room / 2; };
  for (int k = 0; k < columns * rows; ++k) {
    const cv::Point corner(at(k % columns, columns, base.size.width - size.width),
                           at(k / columns, rows, base.size.height - size.height));
    const auto found = match_keypoints(base, match, {corner, size}, heights, search.max_offset);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace xgm::geo
