// SPDX-License-Identifier: Apache-2.0
// What stages take that do not say so themselves.
#include "xgm/stage/needs.hpp"

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/volume.hpp"
#include "xgm/stage/aggregation.hpp"
#include "xgm/stage/consistency.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/penalty.hpp"
#include "xgm/stage/preprocess.hpp"
#include "xgm/stage/refinement.hpp"
#include "xgm/stage/search_range.hpp"
#include "xgm/stage/selection.hpp"

namespace xgm {

Workload Workload::dense(cv::Size size, int planes, Interval range) {
  Workload load;
  load.size = size;
  load.planes = planes;
  load.range = range;
  load.cells_per_pixel = room(range.size());
  return load;
}

double Workload::room(int disparities) {
  constexpr int kGranule = VolumeShape::kGranule;
  return double{kGranule} * ((disparities + kGranule - 1) / kGranule);
}

double Workload::map_bytes() const { return pixels() * (sizeof(float) + 1); }
double Workload::image_bytes() const {
  return pixels() * (double{sizeof(float)} * planes + (masked ? 1 : 0));
}
double Workload::range_bytes() const { return ragged ? pixels() * 2 * sizeof(int) : 0; }
double Workload::shape_bytes() const { return pixels() * 3 * sizeof(int); }

Needs Preprocess::needs(const Workload& load) const {
  return {.others = 2 * load.image_bytes(), .updates = load.pixels()};
}

Needs Cost::needs(const Workload& load) const {
  return {.volumes = load.cells(), .updates = load.cells(), .moved = load.cells()};
}

Needs Penalty::needs(const Workload& load) const {
  return {.others = load.pixels(), .working = 8 * load.pixels(), .updates = load.pixels()};
}

Needs Aggregation::needs(const Workload& load) const {
  constexpr double kPaths = 8;
  constexpr double kBytesOfPasses = 3 + 5;  // costs and sums; once written, once read and written
  return {.volumes = 2 * load.cells(),
          .working = 2 * kPaths * (load.threads + 2) * load.cells_per_pixel * load.size.width,
          .updates = kPaths * load.cells(),
          .moved = kBytesOfPasses * load.cells()};
}

Needs Selection::needs(const Workload& load) const {
  return {.others = load.map_bytes(), .updates = load.cells(), .moved = 2 * load.cells()};
}

Needs Refinement::needs(const Workload& load) const {
  return {.others = load.map_bytes(), .updates = load.pixels()};
}

Needs Filter::needs(const Workload& load) const {
  return {.others = load.map_bytes(), .working = load.map_bytes(), .updates = load.pixels()};
}

Needs Consistency::needs(const Workload& load) const {
  return {.others = 2 * load.map_bytes(), .updates = 2 * load.pixels()};
}

Needs SearchRange::needs(const Workload& load) const {
  return {.others = load.range_bytes(), .working = load.range_bytes(), .updates = load.pixels()};
}

Needs Matcher::needs(const Workload& load) const {
  constexpr double kCostsAndSums = 3;
  return {.others = load.map_bytes() * (gives_reverse_map() ? 2 : 1),
          .working = kCostsAndSums * load.cells(),
          .updates = load.cells(),
          .moved = kCostsAndSums * load.cells()};
}

Planner::Hold Matcher::plan(const Workload& load, const Planner& planner) const {
  return planner.take(needs(load));
}

}  // namespace xgm
