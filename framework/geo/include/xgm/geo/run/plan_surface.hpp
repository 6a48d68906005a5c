// SPDX-License-Identifier: Apache-2.0
// What a surface will take, told before anything is matched.
#pragma once

#include "xgm/geo/run/surface_files.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm::geo {

struct SurfacePlan {
  RunPlan matching;         ///< of the window that takes most, with all that is held beside it
  PlanRequest largest;      ///< that window
  std::size_t pairs = 0;    ///< of images
  std::size_t windows = 0;  ///< of all pairs
  double cells = 0;         ///< of all volumes
  double peak_bytes = 0;    ///< of the process, see peak_memory()
  std::string peak_stage;   ///< in which it is reached: a stage of the matching, "pointing" (and
                            ///< bounding) or "surface"
  double matching_seconds = 0;  ///< of all windows
};

/// Points the cameras, rectifies all windows and bounds their search as a run does; only then it
/// predicts. docs/plan.md says how. Throws UsageError and Error as a run does.
XGM_API SurfacePlan plan_surface(const Pipeline& pipeline, const Registry& registry,
                                 const SurfaceFiles& files, const RunOptions& options = {});

/// For programs: bytes, seconds, px.
XGM_API std::string to_json(const SurfacePlan& plan);

}  // namespace xgm::geo
