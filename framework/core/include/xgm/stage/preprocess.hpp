// SPDX-License-Identifier: Apache-2.0
// Kind "preprocess": from an image pair to a better one.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/needs.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Preprocess : public Stage {
 public:
  static constexpr std::string_view kKind = "preprocess";

  /// The base image keeps its geometry, so that the disparity map stays one of the image given.
  virtual ImagePair run(const ImagePair& pair, const Context& context) const = 0;

  /// What run() takes, for plans; the default: a new pair.
  virtual Needs needs(const Workload& load) const;
};

}  // namespace xgm
