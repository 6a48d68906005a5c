// SPDX-License-Identifier: Apache-2.0
// What cannot go well is not begun; what is wrong with one scene is left to its own run to tell.
#include "xgm/base/error.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {
namespace {

void require_some_range(const BenchRequest& request) {
  for (const BenchPipeline& pipeline : request.pipelines) {
    if (pipeline.disparities) return;
  }
  for (const BenchScene& scene : request.scenes) {
    if (scene.files.disparities) return;
  }
  if (request.scenes.empty()) return;
  const BenchScene& scene = request.scenes.front();
  const auto& faults = scene.files.faults;
  throw UsageError("scene " + scene.files.name + ": " +
                   (faults.empty() ? "nothing says which disparities to search; add a line "
                                     "ndisp=NUMBER to the scene's calib.txt"
                                   : faults.front().message) +
                   ", or --set 'disparities=[MIN, MAX]'");
}

void require_bounds_to_clip_to(const BenchRequest& request) {
  for (const BenchScene& scene : request.scenes) {
    if (scene.files.disparities || !scene.files.faults.empty()) continue;
    throw UsageError("--clip: nothing gives the ndisp of scene " + scene.files.name +
                     "; add a line ndisp=NUMBER to its calib.txt, or leave --clip out");
  }
}

}  // namespace

void check_bench(const BenchRequest& request, const BenchRules& rules) {
  require_some_range(request);
  if (rules.clip) require_bounds_to_clip_to(request);
}

}  // namespace xgm
