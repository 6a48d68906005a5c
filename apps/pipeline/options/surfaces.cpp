// SPDX-License-Identifier: Apache-2.0
#include "options/surfaces.hpp"

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

}  // namespace xgm::cli
