// SPDX-License-Identifier: Apache-2.0
// Cost "census": how many neighbours are darker than the centre in one view but not in the other.
#include "plugins/cost/candidate_costs/candidates.hpp"
#include "plugins/cost/census/hamming.hpp"
#include "plugins/cost/census/transform.hpp"
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
        .one_of({0, 3, 5, 7, 9});
  }

  explicit Census(const Parameters& p)
      : window_(p.window, p.window_height == 0 ? p.window : p.window_height) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const auto transform = [&](const xgm::Image& image, int y, const xgm::cost::RowLayout& layout) {
      return xgm::census::transform(image, y, window_, layout);
    };
    return xgm::cost::compare_rows(images, shape, window_.area() - 1, transform,
                                   xgm::census::hamming);
  }

 private:
  cv::Size window_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Census>("census",
                       "Hamming distance of census bit strings; colour is the mean over channels.",
                       "Zabih & Woodfill, Non-parametric local transforms for computing visual "
                       "correspondence, ECCV 1994");
}
