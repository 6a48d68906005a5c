// SPDX-License-Identifier: Apache-2.0
#include "run/truth_record.hpp"

#include "xgm/base/error.hpp"
#include "xgm/geo/evaluation/true_disparities.hpp"

namespace xgm::geo {

TruthRecord::TruthRecord(const std::string& file) {
  try {
    truth_ = read_raster(file);
  } catch (const Error& error) {
    throw UsageError(error.message());  // nothing has been matched yet
  }
  if (!truth_.crs.empty()) return;
  throw UsageError(file +
                   ": this truth has no CRS, so that a surface cannot be compared with it; give "
                   "true heights with one (gdal_edit.py -a_srs)");
}

SurfaceTruth TruthRecord::judge(const SurfaceResult& result, Observer& observer) const {
  SurfaceTruth judged;
  try {
    judged.surface = compare_surfaces(on_grid_of(result.fused.heights, truth_), truth_.values);
    DisparityJudge judge(truth_);
    for (const Window& window : windows_) judge.add(window.pair, window.map);
    judged.disparities = judge.evaluate();
  } catch (const Error& error) {
    StagePlace place;
    place.path = "truth";
    observer.log(LogLevel::warning, place, error.message());
  }
  return judged;
}

}  // namespace xgm::geo
