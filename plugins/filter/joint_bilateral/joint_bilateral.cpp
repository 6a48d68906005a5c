// SPDX-License-Identifier: Apache-2.0
// Joint bilateral filter: disparities vote for a pixel as far as they are near it and look like it
// in the image. The paper (section 5) names the filter only; the choices made here are in the texts
// of the parameters.
#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/filter/joint_bilateral/votes.hpp"
#include "plugins/filter/joint_bilateral/weights.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::joint_bilateral::Votes;
using xgm::joint_bilateral::Weights;

/// Mean absolute difference of the planes, so that sigma_range means the same for grey and colour.
float colour_distance(float a, float b) { return std::abs(a - b); }
float colour_distance(const cv::Vec3f& a, const cv::Vec3f& b) {
  return (std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2])) / 3.0F;
}

/// The disparities that may vote: not those of pixels without image data, which have no colour.
cv::Mat1f voting_disparities(const xgm::DisparityMap& map, const xgm::Image& guide) {
  if (guide.valid.empty()) return map.disparity;
  cv::Mat1f voting = map.disparity.clone();
  voting.setTo(std::numeric_limits<float>::quiet_NaN(), guide.valid == 0);
  return voting;
}

template <class Pixel>
void collect(const cv::Mat1f& disparity, const cv::Mat_<Pixel>& guide, const Weights& weights,
             int y, int x, Votes& votes) {
  const int radius = weights.radius();
  const int left = std::max(0, x - radius), right = std::min(disparity.cols, x + radius + 1);
  const int bottom = std::min(disparity.rows, y + radius + 1);
  const Pixel centre = guide(y, x);
  votes.clear();
  for (int row = std::max(0, y - radius); row < bottom; ++row) {
    const float* space = weights.space_row(row - y);
    for (int column = left; column < right; ++column) {
      const float value = disparity(row, column);
      if (std::isnan(value)) continue;
      const int weight = weights(space[column - x], colour_distance(guide(row, column), centre));
      if (weight > 0) votes.add(value, weight);
    }
  }
}

class JointBilateral final : public xgm::Filter {
 public:
  enum class Mode { median, mean };
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
        .range(1, xgm::joint_bilateral::kMaxRadius);
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
    const xgm::Image& image = pair.base;
    if (image.planes.size() == 1) return filter(map, image, image.planes.front());
    cv::Mat3f colour;
    cv::merge(image.planes, colour);
    return filter(map, image, colour);
  }

 private:
  template <class Pixel>
  xgm::DisparityMap filter(const xgm::DisparityMap& map, const xgm::Image& image,
                           const cv::Mat_<Pixel>& guide) const {
    const cv::Mat1f voting = voting_disparities(map, image);
    xgm::DisparityMap filtered = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      Votes votes;
      for (int x = 0; x < map.size().width; ++x) {
        if (std::isnan(voting(y, x))) continue;
        collect(voting, guide, weights_, y, x, votes);
        if (!votes.empty()) filtered.disparity(y, x) = combine(votes);
      }
    });
    return filtered;
  }
  float combine(Votes& votes) const {
    return mode_ == Mode::median ? votes.weighted_median()
                                 : static_cast<float>(votes.weighted_mean());
  }

  Weights weights_;
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
