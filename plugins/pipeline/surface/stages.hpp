// SPDX-License-Identifier: Apache-2.0
// What a file of type surface holds.
#pragma once

#include "xgm/geo/stage/fusion.hpp"
#include "xgm/geo/stage/pairs.hpp"
#include "xgm/geo/stage/pointing.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"
#include "xgm/geo/stage/surface.hpp"
#include "xgm/geo/stage/triangulation.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm::geo {

struct SurfaceStages {
  Slot<Pairs> pairs;
  Slot<Pointing> pointing;
  Slot<Rectifier> rectification;
  Slot<RangePrior> range_prior;
  Slot<StereoFamily> matching;
  SlotList<Filter> filters;
  Slot<Triangulation> triangulation;
  Slot<Surface> surface;
  Slot<Fusion> fusion;
  double resolution = 0;
  int tile = 2000;
};

}  // namespace xgm::geo
