// SPDX-License-Identifier: Apache-2.0
// pipeline plan with satellite images.
#pragma once

#include <string>

#include "options/satellites.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm::cli {

struct SurfaceQuestion {
  std::string scene;  ///< in YAML; may be empty
  SatelliteFiles files;
  bool json = false;
};

/// Returns the exit code.
int plan_surface(const Pipeline& pipeline, const Registry& registry,
                 const SurfaceQuestion& question, int threads);

}  // namespace xgm::cli
