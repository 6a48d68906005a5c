// SPDX-License-Identifier: Apache-2.0
// --cloud and --depth: what a run makes of disparities where the cameras are known.
#pragma once

#include <optional>
#include <string>

#include "run_inputs.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm::cli {

/// Decided before any image is opened.
struct DepthPlan {
  std::string cloud;  ///< empty: not asked for
  std::string depth;
  Calibration cameras;
};

/// Nothing if neither was asked for. Throws UsageError if the cameras are not known or a file
/// cannot be written.
std::optional<DepthPlan> plan_depth(const RunOptions& options, const Plan& plan);

/// Writes what was asked for; returns lines that tell so. Throws Error.
std::string write_depth_files(const DepthPlan& plan, const DisparityMap& map, const Image& left);

}  // namespace xgm::cli
