// SPDX-License-Identifier: Apache-2.0
#include "options/surfaces.hpp"

#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include "xgm/geo/stage/surface_family.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
bool makes_surfaces(const Pipeline& pipeline) {
  return dynamic_cast<const geo::SurfaceFamily*>(&pipeline.family()) != nullptr;
}
#else
bool makes_surfaces(const Pipeline&) { return false; }
#endif

void refuse_for_surfaces(std::initializer_list<PairOption> options) {
  for (const PairOption& option : options) {
    if (!option.is_given) continue;
    throw UsageError(std::string(option.name) +
                     ": is for pairs of images, but the pipeline makes surfaces; " + option.remedy);
  }
}

void require_pair_pipeline(const Pipeline& pipeline, const std::string& command,
                           const std::string& remedy) {
  if (!makes_surfaces(pipeline)) return;
  throw UsageError(pipeline.file() + ": makes surfaces of satellite images, but 'pipeline " +
                   command + "' is for pipelines that match one pair; " + remedy);
}

}  // namespace xgm::cli
