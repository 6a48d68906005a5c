// SPDX-License-Identifier: Apache-2.0
// From the books of a pipeline to the peak and the seconds of a run.
#include "xgm/pipeline/plan.hpp"

#include <algorithm>

#include "pipeline/ledger.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/data/volume.hpp"

namespace xgm {
namespace {

// The heap that libraries begin with, code that is loaded when it is first called, stacks: with the
// files in memory, this is the peak of runs on 32 x 24 pixels.
constexpr double kProgramHeap = 14e6;
// Beside the true disparities: those of the other view, and masks.
constexpr double kTruthBytesPerPixel = 9;

/// Work that is done in the processor's caches is as fast as the probe's; what is not waits for
/// memory.
double seconds_of(const PlannedStage& stage, const Experience& experience) {
  const auto speed = experience.speeds.find(stage.kind + "/" + stage.plugin);
  if (speed == experience.speeds.end() || speed->second <= 0) return 0;
  const double waiting = experience.bandwidth > 0 ? stage.needs.moved / experience.bandwidth : 0;
  return std::max(stage.needs.updates / speed->second, waiting);
}

double mean_room(const DisparityRange& range, const cv::Mat1b& valid) {
  double cells = 0, pixels = 0;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) {
      if (!valid.empty() && valid(y, x) == 0) continue;
      cells += Workload::room(range.at(y, x).size());
      ++pixels;
    }
  }
  return pixels > 0 ? cells / pixels : 0;
}

}  // namespace

Workload workload_of(const MatchRequest& request, int threads) {
  const Image& base = request.pair.base;
  Workload load = Workload::dense(request.pair.size(), static_cast<int>(base.planes.size()),
                                  request.range.hull());
  load.threads = threads;
  load.masked = !base.valid.empty();
  if (load.masked) load.used = cv::countNonZero(base.valid) / load.pixels();
  load.ragged = !request.range.is_uniform();
  if (load.ragged) load.cells_per_pixel = mean_room(request.range, base.valid);
  return load;
}

RunPlan plan_run(const Pipeline& pipeline, const PlanRequest& request) {
  PlanLedger ledger{.narrowing = request.experience.narrowing};
  const Workload& load = request.load;
  const Planner planner(ledger);
  const auto program = planner.hold(static_cast<double>(program_memory()) + kProgramHeap);
  const auto truth = planner.hold(request.truth ? kTruthBytesPerPixel * load.pixels() : 0);
  const auto inputs = planner.hold(2 * load.image_bytes() + load.range_bytes());
  pipeline.plan(load, planner);

  RunPlan plan;
  plan.stages = std::move(ledger.stages);
  plan.peak_bytes = ledger.peak_bytes;
  plan.peak_stage = plan.stages[ledger.peak_row].path;
  for (PlannedStage& stage : plan.stages) {
    stage.seconds = seconds_of(stage, request.experience);
    plan.seconds += stage.seconds;
    plan.estimated = plan.estimated || stage.load.estimated;
  }
  return plan;
}

int max_disparities(const Pipeline& pipeline, PlanRequest request, double bytes) {
  const Interval asked = request.load.range;
  const auto fits = [&](int count) {
    request.load.range.end = asked.begin + count;
    request.load.cells_per_pixel = Workload::room(count);
    return plan_run(pipeline, request).peak_bytes <= bytes;
  };
  int good = 0, bad = asked.size() + 1;
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace xgm
