// SPDX-License-Identifier: Apache-2.0
// Sub-pixel disparities from the grey levels themselves. Sums of path costs favour whole
// disparities, since what their neighbours found is whole too: a parabola through three of them is
// drawn towards these ("pixel locking"), by up to 0.2 px on a plane that faces the camera.
#include <algorithm>
#include <cmath>

#include "plugins/filter/least_squares_matching/shifts.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm::least_squares_matching;

class LeastSquaresMatching final : public xgm::Filter {
 public:
  struct Parameters {
    int radius = 3;
    int iterations = 2;
    double deviation = 0.15;
    double jump = 2;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("radius", p.radius,
            "The window reaches this far from its centre on each side; the time grows with its "
            "area.")
        .unit("px")
        .range(1, 15);
    set.add("iterations", p.iterations, "Each begins with the disparities of the one before.")
        .range(1, 10);
    set.add("deviation", p.deviation,
            "Standard deviation of the disparities before; what the window says is weighed against "
            "it by its own. No disparity moves by more than four of it.")
        .unit("px")
        .range(0.01, 2);
    set.add("jump", p.jump,
            "Pixels of the window whose disparity differs by more belong to another surface and "
            "do not count.")
        .unit("px")
        .range(0.1, 100);
  }

  explicit LeastSquaresMatching(Parameters p) : p_(p) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair& pair,
                        const xgm::Context& context) const override {
    xgm::DisparityMap moved = map.clone();
    for (int i = 0; i < p_.iterations; ++i) {
      const Warped warped = warp(moved, pair);
      const cv::Mat1f before = moved.disparity.clone();
      xgm::parallel_for(0, map.size().height, [&](int y) {
        std::vector<Shift> shifts;
        find_shifts(before, warped, {p_.radius, static_cast<float>(p_.jump)}, y, shifts);
        move_row(map.disparity[y], warped.seen[y], shifts, context.searched(), moved.disparity[y]);
      });
    }
    return moved;
  }

 private:
  /// The mean of what the disparity was, and of where the window says it is, by their variances.
  void move_row(const float* original, const float* seen, const std::vector<Shift>& shifts,
                const std::optional<xgm::Interval>& searched, float* disparity) const {
    const auto variance = static_cast<float>(p_.deviation * p_.deviation);
    const auto farthest = static_cast<float>(4 * p_.deviation);
    for (std::size_t x = 0; x < shifts.size(); ++x) {
      if (seen[x] == 0.0F || std::isinf(shifts[x].variance)) continue;
      float low = original[x] - farthest, high = original[x] + farthest;
      if (searched) {
        low = std::max(low, static_cast<float>(searched->begin));
        high = std::min(high, static_cast<float>(searched->end - 1));
      }
      const float there = disparity[x] + shifts[x].mean;
      const float weight = variance / (variance + shifts[x].variance);
      const float to = original[x] + weight * (there - original[x]);
      if (low <= high) disparity[x] = std::clamp(to, low, high);
    }
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<LeastSquaresMatching>(
      "least_squares_matching",
      "Moves matched disparities to where the grey levels around them agree best.",
      "Gruen, Adaptive least squares correlation: a powerful image matching technique, South "
      "African Journal of Photogrammetry, Remote Sensing and Cartography 14(3), 1985; Lucas and "
      "Kanade, An iterative image registration technique with an application to stereo vision, "
      "IJCAI 1981");
}
