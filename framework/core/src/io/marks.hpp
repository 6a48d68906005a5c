// SPDX-License-Identifier: Apache-2.0
// Marks: values such as -9999 by which a file means "no data" without saying so. The rules are in
// docs/conventions.md.
#pragma once

#include <string>
#include <vector>

#include "io/raster.hpp"

namespace xgm {

/// Values that no disparity can be are taken out of `map.valid`; values that may be marks are kept.
/// `divisor` makes px of the values. Returns a warning of each.
std::vector<std::string> mask_marks_of_map(Raster& map, double divisor);

/// The same for an image. One of 8 bit has none.
std::vector<std::string> mask_marks_of_image(Raster& image);

}  // namespace xgm
