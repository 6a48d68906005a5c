// SPDX-License-Identifier: Apache-2.0
// Fills holes from the disparities around them without smearing edges: occluded pixels from the
// background, all others from the middle of what is seen along the paths.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "plugins/filter/discontinuity_preserving_interpolation/occlusions.hpp"
#include "plugins/filter/discontinuity_preserving_interpolation/paths.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace dpi = xgm::discontinuity_preserving_interpolation;
using xgm::DisparityMap;
using xgm::Status;

constexpr std::size_t kMaxDirections = 16;

class Interpolation final : public xgm::Filter {
 public:
  enum class Background { lowest, highest };
  struct Parameters {
    int directions = 8;
    Background background = Background::lowest;
    bool spread_occlusions = true;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("directions", p.directions,
            "Paths along which each hole looks for disparities: 8, or 16 with knight's moves.")
        .one_of({8, 16});
    set.add_choice(
        "background", p.background,
        "Which disparities of the left map are the far ones: the lowest, or the highest where the "
        "images were given the other way round. In the right map it is the reverse, always.",
        {{"lowest", Background::lowest}, {"highest", Background::highest}});
    set.add("spread_occlusions", p.spread_occlusions,
            "Whether areas of mismatched pixels that touch an occluded pixel are filled like "
            "occluded ones.");
  }
  explicit Interpolation(Parameters p) : p_(p) {}

  DisparityMap run(const DisparityMap& map, const xgm::ImagePair& pair,
                   const xgm::Context&) const override {
    const dpi::Holes holes(map);
    const cv::Mat1b occluded = dpi::occlusions(map, p_.spread_occlusions);
    const std::vector<cv::Point> steps = dpi::path_steps(p_.directions);
    std::vector<std::vector<float>> seen(steps.size());
    xgm::parallel_for(0, static_cast<int>(steps.size()), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      seen[k] = dpi::first_along(map.disparity, holes, steps[k]);
    });
    const bool far_is_low = (p_.background == Background::lowest) != pair.is_reverse;
    DisparityMap filled = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      const auto row = static_cast<std::size_t>(y);
      for (std::size_t hole = holes.row_begin[row]; hole < holes.row_begin[row + 1]; ++hole) {
        const int x = holes.column[hole];
        const float value = combine(seen, hole, occluded(y, x) != 0, far_is_low);
        if (!std::isnan(value)) filled.set(y, x, value, Status::filled);
      }
    });
    return filled;
  }

 private:
  /// Of the values seen from a hole, ordered from the background: the second if it is occluded,
  /// else the middle one (of two, the one nearer the background: a mean would lie on no surface).
  /// The only one if there is one, NaN if none.
  static float combine(const std::vector<std::vector<float>>& seen, std::size_t hole, bool occluded,
                       bool far_is_low) {
    const float sign = far_is_low ? 1.0F : -1.0F;
    std::array<float, kMaxDirections> values{};
    std::size_t n = 0;
    for (const std::vector<float>& along : seen) {
      if (!std::isnan(along[hole])) values[n++] = sign * along[hole];
    }
    if (n == 0) return std::numeric_limits<float>::quiet_NaN();
    std::sort(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
    return sign * values[occluded ? std::min<std::size_t>(1, n - 1) : (n - 1) / 2];
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Interpolation>(
      "discontinuity_preserving_interpolation",
      "Fills holes along paths: occluded pixels with the second lowest disparity seen, all others "
      "with the median; masked pixels stay empty.",
      "Hirschmueller, Stereo processing by semiglobal matching and mutual information, PAMI 2008, "
      "section on discontinuity preserving interpolation");
}
