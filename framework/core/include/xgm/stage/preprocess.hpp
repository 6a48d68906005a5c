// SPDX-License-Identifier: Apache-2.0
// Kind "preprocess": from an image pair to a better one.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Preprocess : public Stage {
 public:
  static constexpr std::string_view kKind = "preprocess";
  static constexpr std::string_view kMeaning = "makes a better image pair of an image pair";

  /// The base image keeps its geometry, so that the disparity map stays one of the image given.
  virtual ImagePair run(const ImagePair& pair, const Context& context) const = 0;

  /// What every result is looked at for in a run: sizes, planes, levels and view.
  static std::optional<Fault> fault_of(const ImagePair& result, const ImagePair& pair,
                                       const Context& context);
};

}  // namespace xgm
