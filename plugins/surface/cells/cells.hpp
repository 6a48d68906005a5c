// SPDX-License-Identifier: Apache-2.0
// Points sorted into the cells of a grid.
#pragma once

#include <functional>
#include <span>

#include "xgm/geo/stage/surface.hpp"

namespace xgm::geo {

/// A grid of what `reduce` makes of the heights in each cell, at least one. The heights may be put
/// into another order.
Raster reduce_cells(const GridPoints& points, const GridSpec& grid,
                    const std::function<double(std::span<double>)>& reduce);

}  // namespace xgm::geo
