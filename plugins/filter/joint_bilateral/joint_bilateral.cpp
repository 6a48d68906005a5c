// SPDX-License-Identifier: Apache-2.0
// Joint bilateral filter: disparities vote for a pixel as far as they are near it and look like it
// in the image. The paper (section 5) names the filter only; the choices made here are in the texts
// of the parameters.
#include <limits>

#include "plugins/filter/joint_bilateral/votes.hpp"
#include "plugins/filter/joint_bilateral/window.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace jb = xgm::joint_bilateral;

/// The disparities that may vote: not those of pixels without image data, which have no colour.
cv::Mat1f voting_disparities(const xgm::DisparityMap& map, const xgm::Image& guide) {
  if (guide.valid.empty()) return map.disparity;
  cv::Mat1f voting = map.disparity.clone();
  voting.setTo(std::numeric_limits<float>::quiet_NaN(), guide.valid == 0);
  return voting;
}

class JointBilateral final : public xgm::Filter {
 public:
  using Mode = jb::Mode;
  struct Parameters {
    int radius = 2;
    double sigma_space = 2;
    double sigma_range = 10;
    Mode mode = Mode::median;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("radius", p.radius,
            "The window reaches this far from its centre on each side and is cut off at the image "
            "border; the time grows with its area.")
        .unit("px")
        .range(1, jb::kMaxRadius);
    set.add("sigma_space", p.sigma_space,
            "Standard deviation of the Gaussian weight of the distance from the centre.")
        .unit("px")
        .range(0.1, 1000);
    set.add("sigma_range", p.sigma_range,
            "Standard deviation of the Gaussian weight of the colour distance in the image, the "
            "mean absolute difference of the planes.")
        .unit("grey levels")
        .range(0.1, 1000);
    set.add_choice("mode", p.mode,
                   "How votes are combined: the weighted median never invents a disparity between "
                   "two surfaces, the weighted mean is smoother.",
                   {{"median", Mode::median}, {"mean", Mode::mean}});
  }
  explicit JointBilateral(Parameters p)
      : weights_(p.radius, p.sigma_space, p.sigma_range), mode_(p.mode) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair& pair,
                        const xgm::Context&) const override {
    const jb::Scene scene{voting_disparities(map, pair.base), pair.base.planes, weights_};
    xgm::DisparityMap filtered = map.clone();
    xgm::parallel_for(0, map.size().height,
                      [&](int y) { jb::filter_row(scene, mode_, y, filtered.disparity[y]); });
    return filtered;
  }

 private:
  jb::Weights weights_;
  Mode mode_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<JointBilateral>("joint_bilateral",
                               "Replaces each disparity by the weighted median of those near it, "
                               "near in the plane and in colour.",
                               "Patil et al., A comparative evaluation of SGM variants for dense "
                               "stereo matching, section 5; Petschnigg et al., Digital photography "
                               "with flash and no-flash image pairs, SIGGRAPH 2004");
}
