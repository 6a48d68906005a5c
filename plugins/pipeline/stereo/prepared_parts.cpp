// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/stereo/prepared_parts.hpp"

#include "xgm/data/crop.hpp"

namespace xgm::stereo {
namespace {

class PreparedParts final : public PairWindows {
 public:
  PreparedParts(std::shared_ptr<const PairWindows> scene, const Preprocess& stage,
                std::shared_ptr<const PartPreprocess> fitted)
      : scene_(std::move(scene)), stage_(stage), fitted_(std::move(fitted)) {}

  cv::Size size() const override { return scene_->size(); }

  ImagePair read(const cv::Rect& window) const override {
    if (!fitted_) return stage_.run(scene_->read(window), Context());
    const int margin = fitted_->margin();
    const cv::Rect seen =
        cv::Rect(window.x, window.y - margin, window.width, window.height + 2 * margin) &
        cv::Rect({}, size());
    const ImagePair pair = fitted_->run(scene_->read(seen), seen.tl());
    return seen == window ? pair : crop(pair, window - seen.tl());
  }

 private:
  std::shared_ptr<const PairWindows> scene_;
  const Preprocess& stage_;
  std::shared_ptr<const PartPreprocess> fitted_;
};

}  // namespace

std::shared_ptr<const PairWindows> prepared(std::shared_ptr<const PairWindows> scene,
                                            const Preprocess& stage,
                                            std::shared_ptr<const PartPreprocess> fitted) {
  return std::make_shared<PreparedParts>(std::move(scene), stage, std::move(fitted));
}

}  // namespace xgm::stereo
