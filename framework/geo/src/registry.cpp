// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/registry.hpp"

#include "xgm/geo/stage/fusion.hpp"
#include "xgm/geo/stage/pairs.hpp"
#include "xgm/geo/stage/pointing.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"
#include "xgm/geo/stage/surface.hpp"
#include "xgm/geo/stage/triangulation.hpp"

namespace xgm {

namespace builtin {
void add_geo(Registry& registry);  // generated
}

namespace geo {

void add_geo(Registry& registry) {
  registry.add_kind<Pairs>();
  registry.add_kind<Pointing>();
  registry.add_kind<Rectifier>();
  registry.add_kind<RangePrior>();
  registry.add_kind<Triangulation>();
  registry.add_kind<Surface>();
  registry.add_kind<Fusion>();
  builtin::add_geo(registry);
}

}  // namespace geo
}  // namespace xgm
