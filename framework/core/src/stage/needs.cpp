// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/needs.hpp"

#include "xgm/data/volume.hpp"

namespace xgm {

StatesNeeds::~StatesNeeds() = default;

Workload Workload::dense(cv::Size size, int planes, Interval range) {
  Workload load;
  load.size = size;
  load.planes = planes;
  load.range = range;
  load.cells_per_pixel = room(range.size());
  return load;
}

double Workload::room(int disparities) { return VolumeShape::rounded_up(disparities); }

double Workload::image_bytes() const {
  return pixels() * (double{sizeof(float)} * planes + (masked ? 1 : 0));
}

}  // namespace xgm
