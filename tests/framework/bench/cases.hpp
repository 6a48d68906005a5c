// SPDX-License-Identifier: Apache-2.0
// Results and plans to test benches with.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/bench.hpp"

namespace xgm::testing {

/// A result without cells done: these pipelines on scenes of one set, each of weight 1.
inline BenchResult empty_result(const std::vector<std::string>& pipelines,
                                const std::vector<std::string>& scenes) {
  BenchResult result;
  result.rules.thresholds = {1};
  for (const std::string& name : pipelines) {
    result.request.pipelines.push_back(
        {.name = name, .file = name + ".yaml", .overrides = {}, .resolved = "{}"});
  }
  for (const std::string& name : scenes) {
    BenchScene& scene = result.request.scenes.emplace_back();
    scene.set = "set";
    scene.files.name = name;
  }
  result.cells.resize(pipelines.size() * scenes.size());
  return result;
}

/// A cell whose non-occluded pixels have these figures; those of all pixels are worse by 0.25.
inline BenchCell done(double invalid, double bad, double error, double seconds = 1) {
  BenchCell cell{.state = CellState::done,
                 .failure = {},
                 .seconds = seconds,
                 .peak_bytes = 100e6,
                 .evaluations = 50e6,
                 .density = 1 - invalid};
  Evaluation visible;
  visible.judged = 1000;
  visible.invalid = invalid;
  visible.average_error = error;
  visible.at = {{1, bad, invalid + bad}};
  Evaluation all = visible;
  all.invalid += 0.25;
  all.at[0].total += 0.25;
  cell.regions = {{"all", all}, {"non-occluded", visible}};
  return cell;
}

inline BenchCell failed(const std::string& why) {
  return {.state = CellState::failed, .failure = why};
}

}  // namespace xgm::testing
