// SPDX-License-Identifier: Apache-2.0
// What the stages are given: one generated pair, and what earlier stages make of it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "bench/bench.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin.hpp"

namespace xgm::bench {

void register_volumes();  ///< cost, aggregation, selection, refinement: cells or updates per second
void register_maps();     ///< filters, consistency, search ranges: pixels per second

const Registry& builtins();

template <class Kind>
std::shared_ptr<const Kind> stage(const std::string& yaml) {
  return make_stage<Kind>(yaml, builtins());
}

/// 640 x 480, grey; all disparities are in [0, 64).
const ImagePair& pair();
/// Its upper left corner.
ImagePair pair(cv::Size size);

/// Cells that searching the first `disparities` of all pixels has.
VolumeShapePtr dense(int disparities, cv::Size size = pair().size());
/// As a level of a pyramid has them: 24 to 40 disparities of 256 around the pixel's own, which
/// changes slowly and jumps at edges.
VolumeShapePtr ragged();
/// Of the first so many pixels' cells; not those that only fill slices up.
std::int64_t cells_of(const VolumeShape& shape);

/// Of the corner of the pair that the shape is for.
CostVolume costs_of(const VolumeShapePtr& shape);

/// Left view's map of sgm8_one_view, and the right view's.
const MatchResult& maps();

}  // namespace xgm::bench
