// SPDX-License-Identifier: Apache-2.0
// Preprocess "my_plugin": the logarithm of the grey levels, which brings out what is dark.
#include <algorithm>
#include <cmath>
#include <xgm/plugin.hpp>

namespace {

constexpr float kWhite = 255;

class MyPlugin final : public xgm::Preprocess {
 public:
  struct Parameters {
    double offset = 16;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("offset", p.offset, "Added to grey levels; the smaller, the stronger the effect.")
        .range(1, 255);
  }
  explicit MyPlugin(Parameters p) : offset_(static_cast<float>(p.offset)) {}

  xgm::ImagePair run(const xgm::ImagePair& pair, const xgm::Context&) const override {
    return {changed(pair.base), changed(pair.match), pair.is_reverse};
  }

 private:
  xgm::Image changed(const xgm::Image& image) const {
    xgm::Image result = image;
    for (cv::Mat1f& plane : result.planes) {
      plane = plane.clone();  // copies of matrices share their pixels
      xgm::parallel_for(0, plane.rows, [&](int y) {
        for (int x = 0; x < plane.cols; ++x) plane(y, x) = level(plane(y, x));
      });
    }
    return result;
  }

  /// 0 to 255 as before.
  float level(float grey) const {
    const float stretch = kWhite / std::log1p(kWhite / offset_);
    return stretch * std::log1p(std::max(grey, 0.0F) / offset_);
  }

  float offset_;
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<MyPlugin>("my_plugin", "The logarithm of the grey levels."); }
