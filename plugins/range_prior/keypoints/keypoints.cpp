// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "xgm/geo/camera/meeting.hpp"
#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Keypoints final : public RangePrior {
 public:
  struct Parameters {
    double outliers = 0.02;
    double margin = 0.2;
    double min_margin = 20;
    double max_offset = 2;
    int min_matches = 50;
    int surroundings = 2000;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("outliers", p.outliers, "Share of the key points at both ends that is left out.")
        .range(0, 0.4);
    set.add("margin", p.margin, "Added at both ends, as a share of the heights found.")
        .range(0, 10);
    set.add("min_margin", p.min_margin, "Added at both ends at least.").unit("m").range(0, 9000);
    set.add("max_offset", p.max_offset, "Key points farther from their epipolar line do not count.")
        .unit("px")
        .range(0.1, 100);
    set.add("min_matches", p.min_matches,
            "With fewer in the window those around it count, too; with fewer around it the heights "
            "of the cameras are searched, with a warning.")
        .range(1, 100000);
    set.add("surroundings", p.surroundings,
            "Largest side of the window with what is around it; 0: the window alone.")
        .unit("px")
        .range(0, 20000);
  }

  explicit Keypoints(Parameters parameters) : p_(parameters) {}

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                         const cv::Rect& window, const HeightField*,
                         const Context& context) const override {
    const HeightInterval whole = common_heights(base.camera, match.camera);
    std::vector<double> found = heights_around(base, match, window, whole, context);
    context.figure("keypoints", static_cast<double>(found.size()));
    if (!are_enough(found)) {
      context.warn("only " + std::to_string(found.size()) +
                   " key points match; the heights of the cameras are searched");
      return whole;
    }
    std::sort(found.begin(), found.end());
    const auto at = [&](double share) {
      return found[static_cast<std::size_t>(share * static_cast<double>(found.size() - 1) + 0.5)];
    };
    const double low = at(p_.outliers), high = at(1 - p_.outliers);
    const double margin = std::max(p_.margin * (high - low), p_.min_margin);
    return {std::max(low - margin, whole.min), std::min(high + margin, whole.max)};
  }

 private:
  bool are_enough(const std::vector<double>& heights) const {
    return heights.size() >= static_cast<std::size_t>(p_.min_matches);
  }

  /// Of the window; if they are too few, of one twice as wide and high around it, and so on.
  std::vector<double> heights_around(const SatelliteImage& base, const SatelliteImage& match,
                                     const cv::Rect& window, const HeightInterval& whole,
                                     const Context& context) const {
    std::vector<double> heights = heights_of_keypoints(base, match, window, whole);
    for (cv::Rect around = window; !are_enough(heights);) {
      const cv::Rect wider = widened(around, base.size);
      if (wider == around || std::max(wider.width, wider.height) > p_.surroundings) break;
      around = wider;
      context.figure("surroundings_px", std::max(around.width, around.height));
      heights = heights_of_keypoints(base, match, around, whole);
    }
    return heights;
  }

  static cv::Rect widened(const cv::Rect& window, cv::Size image) {
    const cv::Point more((window.width + 1) / 2, (window.height + 1) / 2);
    return cv::Rect(window.tl() - more, window.br() + more) & cv::Rect({}, image);
  }

  std::vector<double> heights_of_keypoints(const SatelliteImage& base, const SatelliteImage& match,
                                           const cv::Rect& window,
                                           const HeightInterval& whole) const {
    std::vector<double> heights;
    for (const KeypointMatch& m : match_keypoints(base, match, window, whole, p_.max_offset)) {
      const auto here = base.camera.ray(m.base), there = match.camera.ray(m.match);
      if (!here || !there) continue;
      const double height = to_geodetic(meet(*here, *there).point).height;
      if (std::isfinite(height)) heights.push_back(height);
    }
    return heights;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Keypoints>("keypoints",
                          "Heights of key points and a margin, within those of the cameras.");
}
