// SPDX-License-Identifier: Apache-2.0
// Steps sorted by their angle.
#include "plugins/penalty/two_image_gradient/orientation.hpp"

#include <cstdlib>

namespace xgm::two_image_gradient {

Orientation orientation(Direction r) {
  constexpr double kHalfway = 0.41421356237309503;  // tan 22.5 degrees, between axis and diagonal
  const int x = std::abs(r.dx);
  const int y = std::abs(r.dy);
  if (y < kHalfway * x) return Orientation::horizontal;
  if (x < kHalfway * y) return Orientation::vertical;
  return Orientation::diagonal;
}

}  // namespace xgm::two_image_gradient
