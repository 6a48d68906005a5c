// SPDX-License-Identifier: Apache-2.0
// What stages do to scenes in parts unless they say otherwise.
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm {

PartPreprocess::~PartPreprocess() = default;

std::shared_ptr<const PartPreprocess> Preprocess::fitted(const PairWindows&, const Context&) const {
  return nullptr;
}

std::shared_ptr<const PairWindows> StereoFamily::prepared(std::shared_ptr<const PairWindows> scene,
                                                          const Context&) const {
  return scene;
}

}  // namespace xgm
