// SPDX-License-Identifier: Apache-2.0
// Whether a path counts as horizontal, vertical or diagonal.
#pragma once

#include "xgm/stage/penalty.hpp"

namespace xgm::two_image_gradient {

enum class Orientation { horizontal, vertical, diagonal };

/// The nearest by angle. The paper does not say what a knight's move is; (2, 1) is 27 degrees from
/// the horizontal and 18 from the diagonal, so all eight of them count as diagonal.
Orientation orientation(Direction r);

}  // namespace xgm::two_image_gradient
