// SPDX-License-Identifier: Apache-2.0
// Every pipeline on every scene, as jobs.
#include <algorithm>

#include "bench/identity.hpp"
#include "bench/judge.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

BenchResult run_bench(const BenchRequest& request, const BenchRules& rules,
                      const BenchHooks& hooks) {
  BenchResult result{request, rules, {}};
  const std::size_t pipelines = request.pipelines.size();
  std::vector<BenchJob> jobs;
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < pipelines; ++i) {
      jobs.push_back({.pipeline = request.pipelines[i].name,
                      .scene = request.scenes[scene].files.name,
                      .folder = cell_folder(request, i, scene),
                      .identity = cell_identity(request, i, scene),
                      .result = "disparity.pfm"});
    }
  }
  result.cells.resize(jobs.size());
  const auto scene_of = [&](std::size_t i) -> const BenchScene& {
    return request.scenes[i / pipelines];
  };
  result.interrupted = run_jobs(
      jobs, {.run =
                 [&](std::size_t i) {
                   return hooks.run(request.pipelines[i % pipelines], scene_of(i), jobs[i].folder);
                 },
             .judge =
                 [&](std::size_t i) {
                   const BenchCell cell = judge_cell(jobs[i].folder, scene_of(i), rules);
                   result.cells[i] = cell;
                   return JobFigures{.seconds = cell.seconds, .peak_bytes = cell.peak_bytes};
                 },
             .fail =
                 [&](std::size_t i, const std::string& why) {
                   result.cells[i] = {.state = CellState::failed, .failure = why};
                 },
             .tell = hooks.tell});
  return result;
}

bool BenchResult::any_done(std::size_t scene) const {
  for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
    if (at(i, scene).state == CellState::done) return true;
  }
  return false;
}

std::size_t BenchResult::failures() const {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](const auto& cell) {
    return cell.state == CellState::failed;
  }));
}

}  // namespace xgm
