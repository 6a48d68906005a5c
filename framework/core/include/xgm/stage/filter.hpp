// SPDX-License-Identifier: Apache-2.0
// Kind "filter": from a disparity map to a better one.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Filter : public Stage {
 public:
  static constexpr std::string_view kKind = "filter";
  static constexpr std::string_view kMeaning = "makes a better disparity map of a disparity map";

  /// `pair.base` is the view that `map` belongs to. Returns a map of the same size.
  virtual DisparityMap run(const DisparityMap& map, const ImagePair& pair,
                           const Context& context) const = 0;
};

}  // namespace xgm
