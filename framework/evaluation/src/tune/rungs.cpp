// SPDX-License-Identifier: Apache-2.0
// How the budget of runs is spent.
#include <algorithm>
#include <cmath>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/tune.hpp"

namespace xgm {
namespace {

std::size_t halved(std::size_t count, std::size_t times) {
  const std::size_t divisor = std::size_t{1} << times;
  return (count + divisor - 1) / divisor;
}

/// That many halvings leave two pipelines, and no rung has fewer than one scene.
std::size_t count_rungs(std::size_t pipelines, std::size_t scenes) {
  std::size_t rungs = 1;
  while (halved(pipelines, rungs - 1) > 2 && (std::size_t{1} << rungs) <= scenes) ++rungs;
  return rungs;
}

}  // namespace

std::vector<Rung> plan_rungs(std::size_t pipelines, std::size_t scenes) {
  const std::size_t count = count_rungs(pipelines, scenes);
  std::vector<Rung> rungs;
  for (std::size_t i = 0; i < count; ++i) {
    rungs.push_back({std::max(std::min<std::size_t>(2, pipelines), halved(pipelines, i)),
                     halved(scenes, count - 1 - i)});
  }
  return rungs;
}

std::size_t runs_of(const std::vector<Rung>& rungs) {
  std::size_t runs = 0, scenes = 0;
  for (const Rung& rung : rungs) {
    runs += rung.pipelines * (rung.scenes - scenes);
    scenes = rung.scenes;
  }
  return runs;
}

std::size_t affordable_pipelines(std::size_t budget, std::size_t scenes, std::size_t held_out) {
  const auto needed = [&](std::size_t pipelines) {
    return runs_of(plan_rungs(pipelines, scenes)) + 2 * held_out;
  };
  if (needed(2) > budget) {
    throw UsageError("--budget " + std::to_string(budget) + ": two pipelines on all scenes take " +
                     std::to_string(needed(2)) + " runs; give more, or fewer --scenes");
  }
  // More of them may take fewer runs, when a rung is added.
  std::size_t pipelines = budget;
  while (needed(pipelines) > budget) --pipelines;
  return pipelines;
}

std::size_t held_out_count(double share, std::size_t scenes) {
  if (share <= 0 || scenes < 2) return 0;
  const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(scenes)));
  return std::clamp<std::size_t>(wanted, 1, scenes - 1);
}

}  // namespace xgm
