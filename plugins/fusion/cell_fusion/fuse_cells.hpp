// SPDX-License-Identifier: Apache-2.0
// Surfaces of pairs made into one, cell by cell, by a rule that makes one height of several.
#pragma once

#include <functional>
#include <vector>

#include "xgm/geo/stage/fusion.hpp"

namespace xgm::geo {

struct CellFusion {
  bool align = false;
  int min_pairs = 1;
};
void describe(CellFusion& fusion, ParameterSet& set);

/// One height of those of a cell, at least one; may change their order. Called by several threads.
using HeightRule = std::function<float(std::vector<float>& heights)>;

/// Half the sum of the two in the middle, if there are two. Changes the order.
float median(std::vector<float>& values);

FusedSurface fuse_cells(const std::vector<Raster>& surfaces, const CellFusion& fusion,
                        const HeightRule& rule, const Context& context);

}  // namespace xgm::geo
