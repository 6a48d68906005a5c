// SPDX-License-Identifier: Apache-2.0
// Asking a forest.
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/fuser/forest/forest_file.hpp"
#include "xgm/base/export.hpp"

namespace xgm::forest {

/// The sums of the scores that the trees give the matchers, pixel by pixel: `matchers` of each.
/// `features` holds as many bytes as the forest has features, of each pixel. One tree after the
/// other is asked about all pixels, so that it stays in the cache: the pixels of a row, say.
XGM_API std::vector<int> votes(const Forest& forest, const std::vector<std::uint8_t>& features);

}  // namespace xgm::forest
