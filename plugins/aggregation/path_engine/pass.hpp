// SPDX-License-Identifier: Apache-2.0
// Passes: the order in which pixels are visited, and the paths that are extended at each pixel.
#pragma once

#include <algorithm>
#include <array>
#include <opencv2/core/types.hpp>
#include <vector>

#include "xgm/stage/penalty.hpp"

namespace xgm::aggregation {

/// `r` turned anticlockwise by 90 degrees as seen on the screen (x to the right, y down).
constexpr Direction anticlockwise(Direction r) { return {r.dy, -r.dx}; }

/// One path, with path costs L_r. L_r(p, .) is computed from L_r(p - x, .) for each x of `steps`: r
/// alone (sgm), or r and r-perp (mgm), whose messages are averaged.
struct Path {
  std::vector<Direction> steps;
};

/// A pass visits the image line by line. `along` leads from a pixel to the next one of its line,
/// `across` from a line to the next one; they are axis directions at right angles. In these
/// coordinates, (u, v) is pixel u of line v.
struct Pass {
  Direction along;
  Direction across;
  std::vector<Path> paths;
};

/// The forward pass and the backward pass, which is the same turned by 180 degrees: it visits the
/// pixels from the last to the first, and its paths have the opposite steps.
inline std::array<Pass, 2> both_directions(const Pass& pass) {
  const auto turn = [](Direction& x) { x = {-x.dx, -x.dy}; };
  Pass opposite = pass;
  turn(opposite.along);
  turn(opposite.across);
  for (Path& path : opposite.paths) std::ranges::for_each(path.steps, turn);
  return {pass, opposite};
}

/// Step x in the coordinates of a pass: pixels along the line, and lines.
constexpr int pixels_along(Direction x, Direction along) {
  return x.dx * along.dx + x.dy * along.dy;
}
constexpr int lines_across(Direction x, Direction across) {
  return x.dx * across.dx + x.dy * across.dy;
}

/// Whether p - x is visited before p.
constexpr bool comes_earlier(Direction x, Direction along, Direction across) {
  const int lines = lines_across(x, across);
  return lines > 0 || (lines == 0 && pixels_along(x, along) > 0);
}

/// Maps (u, v) of a pass to image coordinates. The lines of the pass are numbered from first_line
/// on.
class PassFrame {
 public:
  PassFrame(cv::Size size, Direction along, Direction across, int first_line = 0)
      : along_(along),
        across_(across),
        first_line_(first_line),
        length_(along.dx != 0 ? size.width : size.height),
        lines_(along.dx != 0 ? size.height : size.width),
        origin_(along.dx + across.dx < 0 ? size.width - 1 : 0,
                along.dy + across.dy < 0 ? size.height - 1 : 0) {}

  int length() const { return length_; }  ///< pixels of a line
  int lines() const { return lines_; }
  int first_line() const { return first_line_; }
  Direction along() const { return along_; }
  bool lines_are_rows() const { return along_.dx != 0; }
  cv::Point pixel(int u, int v) const {
    v -= first_line_;
    return {origin_.x + u * along_.dx + v * across_.dx, origin_.y + u * along_.dy + v * across_.dy};
  }

 private:
  Direction along_, across_;
  int first_line_, length_, lines_;
  cv::Point origin_;
};

}  // namespace xgm::aggregation
