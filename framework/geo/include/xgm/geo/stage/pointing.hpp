// SPDX-License-Identifier: Apache-2.0
// Kind "pointing": corrects where cameras look, which vendors know to some pixels only.
#pragma once

#include <string_view>
#include <vector>

#include "xgm/geo/image/satellite_image.hpp"
#include "xgm/geo/stage/pairs.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

/// What is known of the ground when cameras are corrected.
struct GroundKnowledge {
  const HeightField* dem = nullptr;  ///< null: none
  HeightInterval heights;            ///< of the ground, m
};

class XGM_API Pointing : public Stage {
 public:
  static constexpr std::string_view kKind = "pointing";
  static constexpr std::string_view kMeaning = "corrects where satellite cameras look";

  /// Whether it can do nothing without a DEM.
  virtual bool needs_dem() const { return false; }

  /// The images with corrected cameras, in the same order.
  virtual std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                          const std::vector<PairChoice>& pairs,
                                          const GroundKnowledge& ground,
                                          const Context& context) const = 0;
};

}  // namespace xgm::geo
