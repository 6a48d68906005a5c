// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/tiling.hpp"

namespace xgm::tiles {
namespace {

cv::Rect grown(const cv::Rect& r, int left, int right, int rows) {
  return {r.x - left, r.y - rows, r.width + left + right, r.height + 2 * rows};
}

cv::Rect aligned(const cv::Rect& r, int alignment) {
  const auto down = [&](int v) { return v - ((v % alignment) + alignment) % alignment; };
  const cv::Point begin(down(r.x), down(r.y));
  const cv::Point end(down(r.br().x + alignment - 1), down(r.br().y + alignment - 1));
  return {begin, end};
}

}  // namespace

Surroundings surroundings(const cv::Rect& core, int halo, Interval disparities, cv::Size image,
                          int alignment) {
  const cv::Rect whole({}, image);
  const int first = disparities.begin, last = disparities.end - 1;
  Surroundings around;
  around.searched = grown(core, halo, halo, halo) & whole;
  // A base pixel in column x is seen in columns x - last to x - first of the match image.
  const cv::Rect& s = around.searched;
  const cv::Rect seen(s.x - last, s.y, s.width + last - first, s.height);
  around.reverse_searched = grown(seen, halo, halo, 0) & whole;
  // A match pixel in column x may be seen in columns x + first to x + last of the base image.
  const cv::Rect& r = around.reverse_searched;
  const cv::Rect back(r.x + first, r.y, r.width + last - first, r.height);
  around.window = aligned(s | seen | r | back, alignment) & whole;
  return around;
}

}  // namespace xgm::tiles
