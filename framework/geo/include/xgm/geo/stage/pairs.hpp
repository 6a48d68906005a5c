// SPDX-License-Identifier: Apache-2.0
// Kind "pairs": which images are matched with each other?
#pragma once

#include <string_view>
#include <vector>

#include "xgm/geo/image/satellite_image.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

/// Indices of images.
struct PairChoice {
  std::size_t base = 0;
  std::size_t match = 0;
};

class XGM_API Pairs : public Stage {
 public:
  static constexpr std::string_view kKind = "pairs";
  static constexpr std::string_view kMeaning = "chooses which satellite images are matched";

  /// At least two images. Each pair is named once; best first.
  virtual std::vector<PairChoice> run(const std::vector<SatelliteImage>& images,
                                      const Context& context) const = 0;
};

}  // namespace xgm::geo
