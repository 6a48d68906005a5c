// SPDX-License-Identifier: Apache-2.0
// What stages do to scenes in parts unless they say otherwise.
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm {

PartPreprocess::~PartPreprocess() = default;

std::string PartPreprocess::state() const { return {}; }

std::shared_ptr<const PartPreprocess> Preprocess::fitted(const PairWindows&, const Context&) const {
  return nullptr;
}

std::shared_ptr<const PartPreprocess> Preprocess::restored(const std::string&, cv::Size) const {
  return nullptr;
}

std::shared_ptr<const PairWindows> StereoFamily::prepared(std::shared_ptr<const PairWindows> scene,
                                                          const Context&) const {
  return scene;
}

std::string StereoFamily::found_on_whole(std::shared_ptr<const PairWindows>, const Context&) const {
  return "null";
}

std::shared_ptr<const PairWindows> StereoFamily::prepared_with(
    const std::string&, std::shared_ptr<const PairWindows> scene, const Context& context) const {
  return prepared(std::move(scene), context);
}

}  // namespace xgm
