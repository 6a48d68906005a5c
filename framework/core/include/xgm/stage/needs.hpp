// SPDX-License-Identifier: Apache-2.0
// For stages that say what they take, so that plans of a run's memory and time know more than what
// can be seen from outside. Nobody has to: see docs/plan.md for what is assumed of the others.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// The inputs of a stage in numbers. Bytes and counts are doubles: most are products of large ones,
/// and some are estimates.
struct XGM_API Workload {
  cv::Size size;               ///< of the images, px
  int planes = 1;              ///< of each image
  bool masked = false;         ///< whether the images have masks
  double used = 1;             ///< share of the base pixels that have data, 0 to 1
  Interval range;              ///< every disparity that is searched lies in it
  double cells_per_pixel = 0;  ///< mean VolumeShape::room() of the pixels that have data
  bool ragged = false;         ///< whether pixels search disparities of their own
  bool estimated = false;      ///< whether cells_per_pixel is a guess: it depends on the scene
  int threads = 1;

  /// All pixels search all of `range`.
  static Workload dense(cv::Size size, int planes, Interval range);
  /// Cells of a pixel that searches so many disparities: a multiple of VolumeShape::kGranule.
  static double room(int disparities);

  double pixels() const { return static_cast<double>(size.width) * size.height; }
  double cells() const { return pixels() * used * cells_per_pixel; }
  double image_bytes() const;  ///< of one Image
};

/// What run() of a stage takes beside its inputs and its result, without the stages inside it.
struct Needs {
  double working = 0;  ///< bytes, the most at one time
  double updates = 0;  ///< rounds of its innermost loop: its seconds grow with them
  double moved = 0;    ///< bytes of volumes that it reads and writes
};

/// A second base for stage classes, beside their kind:
///   class Sgm final : public xgm::Aggregation, public xgm::StatesNeeds { ... };
class XGM_API StatesNeeds {
 public:
  virtual ~StatesNeeds();
  virtual Needs needs(const Workload& load) const = 0;
};

}  // namespace xgm
