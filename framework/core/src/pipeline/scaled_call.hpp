// SPDX-License-Identifier: Apache-2.0
// From a call in a small run to the same call in a run of another size.
#pragma once

#include "pipeline/trace.hpp"

namespace xgm::trace {

class Scale {
 public:
  /// `to`: the workload of the whole pair in the other run.
  Scale(const RunTrace& trace, const Workload& to);

  /// What the call will be given.
  Workload load(const Call& call) const;
  /// What it says of itself, else what is assumed of a stage that says nothing.
  Needs needs(const Call& call, const Workload& load) const;
  /// Of a copy of what it returns.
  double kept_bytes(const Call& call) const;
  /// Of images, maps, ranges and shapes that `by` was given or returned.
  double pixel_bytes(const Buffer& buffer, const Call& by) const;
  /// Of a volume that was seen first in `call`.
  double volume_bytes(const Buffer& buffer, const Call& call) const;

 private:
  cv::Size size(cv::Size small, const Level& level) const;
  /// Whether the call belongs to a level that searches around what a coarser one has found. Beside
  /// a pyramid, matchers of a fusion may search everything.
  bool is_narrowed(const Call& call) const {
    return !call.place.level.name.empty() && call.place.level.scale < coarsest_;
  }

  const RunTrace& trace_;
  const Workload& from_;
  Workload to_;
  double coarsest_ = 1;
};

}  // namespace xgm::trace
