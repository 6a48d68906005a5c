// SPDX-License-Identifier: Apache-2.0
// Points sorted into the cells of a grid: for surfaces and their layers.
#pragma once

#include <functional>
#include <span>

#include "xgm/geo/stage/surface.hpp"

namespace xgm::geo {

/// The median; half the sum of the two in the middle, if there are two. Changes the order. At least
/// one value.
XGM_API double median(std::span<double> values);

/// A grid of what `reduce` makes of the heights in each cell, at least one. The heights may be put
/// into another order. A point on the border of two cells belongs to the one to the east or south.
XGM_API Raster reduce_cells(const GridPoints& points, const GridSpec& grid,
                            const std::function<double(std::span<double>)>& reduce);

}  // namespace xgm::geo
