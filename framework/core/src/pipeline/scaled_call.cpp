// SPDX-License-Identifier: Apache-2.0
#include "pipeline/scaled_call.hpp"

#include <algorithm>
#include <cmath>

#include "stage/misbehaviour.hpp"
#include "xgm/base/error.hpp"
#include "xgm/data/interval_mapping.hpp"

namespace xgm::trace {
namespace {

int divided(int n, double scale) { return static_cast<int>(std::ceil(n / scale)); }

cv::Size divided(cv::Size size, double scale) {
  return {divided(size.width, scale), divided(size.height, scale)};
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

/// What a stage says of itself, if it can be used.
Needs stated(const StatesNeeds& stage, const Workload& load, const StagePlace& place) {
  try {
    const Needs needs = stage.needs(load);
    for (const double number : {needs.working, needs.updates, needs.moved}) {
      if (std::isfinite(number) && number >= 0) continue;
      throw Error(name_of(place) +
                  " states needs that are no numbers of 0 or more; correct the "
                  "plugin, or use another one");
    }
    return needs;
  } catch (...) {
    rethrow_as_error(place);
  }
}

}  // namespace

Scale::Scale(const RunTrace& trace, const Workload& to)
    : trace_(trace), from_(trace.calls().load), to_(to) {
  for (const Call& call : trace.calls().calls) {
    if (call.is_matcher) coarsest_ = std::max(coarsest_, call.place.level.scale);
  }
}

/// Levels are so many times smaller, rounded up; stages that change sizes otherwise do so in
/// proportion.
cv::Size Scale::size(cv::Size small, const Level& level) const {
  if (small == divided(from_.size, level.scale)) return divided(to_.size, level.scale);
  return {std::max(1, static_cast<int>(
                          std::lround(small.width * ratio(to_.size.width, from_.size.width)))),
          std::max(1, static_cast<int>(
                          std::lround(small.height * ratio(to_.size.height, from_.size.height))))};
}

Workload Scale::load(const Call& call) const {
  Workload load = to_;
  load.size = size(call.size, call.place.level);
  load.planes = std::max(1, call.planes * to_.planes / std::max(1, from_.planes));
  load.range = divided(to_.range, call.place.level.scale);
  const double all = Workload::room(load.range.size());
  if (trace_.narrowing && is_narrowed(call)) {
    const Narrowing& narrowing = *trace_.narrowing;
    load.cells_per_pixel = std::min(all, narrowing.spread + narrowing.lost * load.range.size());
    load.ragged = load.estimated = true;
  } else {
    load.cells_per_pixel = all * ratio(to_.cells_per_pixel, Workload::room(to_.range.size()));
  }
  return load;
}

/// A stage that says nothing holds half as much as the images and maps it is given, and at least as
/// much again as it returns of these; a matcher whose stages cannot be seen, costs and sums of all
/// that it searches. Its work is a look at every cell of its volumes, else at every pixel.
Needs Scale::needs(const Call& call, const Workload& load) const {
  if (call.same_as >= 0) return {};  // it does not run
  if (const auto* stating = dynamic_cast<const StatesNeeds*>(call.place.stage)) {
    return stated(*stating, load, call.place);
  }
  if (!call.is_leaf) return {.updates = load.pixels()};
  constexpr double kCostsAndSums = 3;
  if (call.is_matcher) return {.working = kCostsAndSums * load.cells(), .updates = load.cells()};
  const double seen = std::max(call.given_bytes / 2, call.returned_bytes);
  return {.working = seen * ratio(load.pixels(), call.size.area()),
          .updates = call.has_volumes ? load.cells() : load.pixels()};
}

double Scale::kept_bytes(const Call& call) const {
  return call.returned_bytes * ratio(load(call).pixels(), call.size.area());
}

double Scale::pixel_bytes(const Buffer& buffer, const Call& by) const {
  const cv::Size large = size(buffer.size, by.place.level);
  return buffer.bytes * ratio(double(large.width) * large.height, buffer.size.area());
}

double Scale::volume_bytes(const Buffer& buffer, const Call& call) const {
  const double cells = call.cells_per_pixel * from_.used * call.size.area();
  return buffer.bytes * ratio(load(call).cells(), cells);
}

}  // namespace xgm::trace
