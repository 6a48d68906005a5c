// SPDX-License-Identifier: Apache-2.0
// Filter "trim_border": takes the disparities near the image border away, where windows are cut.
#include <xgm/plugin.hpp>

namespace {

class TrimBorder final : public xgm::Filter {
 public:
  struct Parameters {
    int width = 2;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("width", p.width, "Pixels this near to the border lose their disparity.")
        .unit("px")
        .range(0, 1000);
  }
  explicit TrimBorder(Parameters p) : width_(p.width) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context& context) const override {
    xgm::DisparityMap trimmed = map.clone();
    const cv::Rect kept(width_, width_, map.size().width - 2 * width_,
                        map.size().height - 2 * width_);
    int lost = 0;
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (!map.has_disparity(y, x) || kept.contains({x, y})) continue;
        trimmed.invalidate(y, x, xgm::Status::out_of_range);
        ++lost;
      }
    }
    context.figure("trimmed_pixels", lost);
    return trimmed;
  }

 private:
  int width_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<TrimBorder>("trim_border", "Takes away the disparities near the image border.");
}
