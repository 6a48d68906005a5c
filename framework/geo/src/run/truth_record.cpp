// SPDX-License-Identifier: Apache-2.0
#include "run/truth_record.hpp"

#include "xgm/base/error.hpp"
#include "xgm/geo/evaluation/true_disparities.hpp"

namespace xgm::geo {

SurfaceTruth TruthRecord::judge(const SurfaceResult& result,
                                std::vector<std::string>& warnings) const {
  SurfaceTruth judged;
  try {
    judged.surface = compare_surfaces(on_grid_of(result.fused.heights, truth_), truth_.values);
    DisparityJudge judge(truth_);
    for (const Window& window : windows_) judge.add(window.pair, window.map);
    judged.disparities = judge.evaluate();
  } catch (const Error& error) {
    warnings.push_back("truth: " + error.message());
  }
  return judged;
}

}  // namespace xgm::geo
