// SPDX-License-Identifier: Apache-2.0
// Kind "triangulation": from disparities to points on the ground.
#pragma once

#include <string_view>

#include "xgm/geo/image/point_grid.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

class XGM_API Triangulation : public Stage {
 public:
  static constexpr std::string_view kKind = "triangulation";
  static constexpr std::string_view kMeaning = "makes points on the ground of disparities";

  virtual PointGrid run(const RectifiedPair& pair, const DisparityMap& map,
                        const Context& context) const = 0;
};

}  // namespace xgm::geo
