// SPDX-License-Identifier: Apache-2.0
// Curves over the disparity, drawn in ASCII.
#pragma once

#include <string>
#include <vector>

#include "xgm/data/disparity_range.hpp"

namespace xgm::explain {

/// A letter under a disparity.
struct Mark {
  char letter = ' ';
  int disparity = 0;
};

/// `rows` lines of stars, the lowest value at the bottom, then an axis with the marks (the first of
/// two in one column wins) and the ends of the range. Long ranges are binned: a column shows the
/// lowest value of its disparities. Empty if there is nothing to draw.
std::string plot(const std::vector<float>& curve, Interval range, const std::vector<Mark>& marks,
                 const std::string& title, int rows);

}  // namespace xgm::explain
