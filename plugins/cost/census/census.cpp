// SPDX-License-Identifier: Apache-2.0
// Cost "census": how many neighbours are darker than the centre in one view but not in the other.
#include <algorithm>

#include "plugins/cost/census/hamming.hpp"
#include "plugins/cost/census/transform.hpp"
#include "plugins/cost/shared/candidates.hpp"
#include "xgm/plugin.hpp"

namespace {

class Census final : public xgm::Cost {
 public:
  struct Parameters {
    int window = 5;
    int window_height = 0;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window, "Side of the square window, or its width if window_height is set.")
        .unit("px")
        .range(3, 9)
        .odd();
    set.add("window_height", p.window_height, "Height of the window; 0 makes it square.")
        .unit("px")
        .range(0, 9);
    set.rule({"window_height"}, "must be 0, 3, 5, 7 or 9", [&p] {
      return p.window_height == 0 || (p.window_height >= 3 && p.window_height % 2 == 1);
    });
  }

  explicit Census(const Parameters& p)
      : window_(p.window, p.window_height == 0 ? p.window : p.window_height) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const xgm::ImagePair pair = xgm::cost::comparable(images);
    xgm::CostVolume costs(shape, window_.area() - 1);
    const auto channels = static_cast<int>(pair.base.planes.size());
    const xgm::census::RowLayout mirrored = candidates_of(*shape);
    xgm::parallel_for(0, shape->height(), [&](int y) {
      const auto base = xgm::census::transform(pair.base, y, window_);
      const auto match = xgm::census::transform(pair.match, y, window_, mirrored);
      xgm::census::hamming({base, match, channels}, y, costs);
    });
    return costs;
  }

 private:
  /// A match row that holds a candidate, or says that there is none, for every cell and for what
  /// lies between a slice's last cell and its end.
  static xgm::census::RowLayout candidates_of(const xgm::VolumeShape& shape) {
    const xgm::Interval hull = shape.hull();
    return {true, std::max(0, -hull.begin), std::max(0, hull.end) + xgm::VolumeShape::kGranule};
  }

  cv::Size window_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Census>("census",
                       "Hamming distance of census bit strings; colour is the mean over channels.",
                       "Zabih & Woodfill, Non-parametric local transforms for computing visual "
                       "correspondence, ECCV 1994");
}
