// SPDX-License-Identifier: Apache-2.0
// Kind "rectification": brings corresponding points of two satellite images into one row.
#pragma once

#include <memory>
#include <string_view>

#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

class XGM_API Rectifier : public Stage {
 public:
  static constexpr std::string_view kKind = "rectification";
  static constexpr std::string_view kMeaning =
      "brings corresponding points of satellite images into one row";

  /// For a window of the base image and ground of those heights. The rectified base image shows the
  /// whole window; disparities of the middle of the heights are about 0.
  virtual std::shared_ptr<const Rectification> run(const SatelliteImage& base,
                                                   const SatelliteImage& match,
                                                   const cv::Rect& window,
                                                   const HeightInterval& heights,
                                                   const Context& context) const = 0;
};

}  // namespace xgm::geo
