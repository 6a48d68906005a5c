// SPDX-License-Identifier: Apache-2.0
// Truths and masks of generated scenes, judged by nothing but the images and the truths themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/support.hpp"
#include "xgm/synthesis/generate.hpp"

using namespace xgm;
using namespace xgm::synthesis;

namespace {

Options small_scene(std::uint64_t seed) {
  Options options;
  options.size = {320, 240};
  options.disparities = {0, 40};
  options.seed = seed;
  return options;
}

/// One view of a scene, and the other one as it is seen from there.
struct Side {
  cv::Mat1f image, other_image;
  cv::Mat1f truth, other_truth;
  cv::Mat1b visible;
  double sign = 1;  ///< what is nearer has a larger sign * disparity
};

Side side(const GeneratedScene& scene, bool reverse) {
  const cv::Mat1f base = scene.pair.base.grey(), match = scene.pair.match.grey();
  if (reverse)
    return {match, base, scene.reverse_truth, scene.truth, scene.reverse_non_occluded, -1};
  return {base, match, scene.truth, scene.reverse_truth, scene.non_occluded, 1};
}

/// A windowed sinc through 12 pixels: images through a lens are smooth enough for it.
double interpolated(const cv::Mat1f& image, int y, double x) {
  constexpr int kReach = 6;
  const int left = static_cast<int>(std::floor(x));
  double sum = 0, weights = 0;
  for (int i = left - kReach + 1; i <= left + kReach; ++i) {
    const double t = (x - i) * std::numbers::pi;
    const double sinc = std::abs(t) < 1e-9 ? 1 : std::sin(t) / t;
    const double weight = sinc * (0.5 + 0.5 * std::cos(t / kReach));
    sum += weight * static_cast<double>(image(y, std::clamp(i, 0, image.cols - 1)));
    weights += weight;
  }
  return sum / weights;
}

/// No edge of a surface within the reach of lens and interpolation.
bool smooth_around(const cv::Mat1f& truth, int y, double x) {
  const int column = static_cast<int>(std::lround(x));
  const cv::Rect window(column - 7, y - 2, 15, 5);
  if ((window & cv::Rect({}, truth.size())) != window) return false;
  double low = 0, high = 0;
  cv::minMaxLoc(truth(window), &low, &high);
  return high - low < 2;
}

bool textured(const cv::Mat1f& image, int y, int x) {
  return std::abs(image(y, x + 1) - image(y, x - 1)) > 12;
}

struct Photometry {
  int pixels = 0;
  std::array<double, 3> error{};  ///< mean difference at truth - 1, truth, truth + 1
};

Photometry photometry(const Side& s) {
  Photometry result;
  for (int y = 0; y < s.truth.rows; ++y) {
    for (int x = 1; x + 1 < s.truth.cols; ++x) {
      const double x_other = x - static_cast<double>(s.truth(y, x));
      if (s.visible(y, x) == 0 || !textured(s.image, y, x) || !smooth_around(s.truth, y, x) ||
          !smooth_around(s.other_truth, y, x_other))
        continue;
      ++result.pixels;
      for (const int k : {0, 1, 2})
        result.error[static_cast<std::size_t>(k)] += std::abs(
            interpolated(s.other_image, y, x_other + 1 - k) - static_cast<double>(s.image(y, x)));
    }
  }
  for (double& sum : result.error) sum /= std::max(result.pixels, 1);
  return result;
}

/// What the two pixels around its place in the other view tell of a pixel.
enum class Verdict { seen, hidden, undecided };

Verdict brute_force(const Side& s, int y, int x) {
  const double d = static_cast<double>(s.truth(y, x)), x_other = x - d;
  if (x_other < 0 || x_other > s.truth.cols - 1) return Verdict::hidden;
  int same = 0, nearer = 0;
  for (const double column : {std::floor(x_other), std::ceil(x_other)}) {
    const double other = -static_cast<double>(s.other_truth(y, static_cast<int>(column)));
    if (std::abs(other - d) < 0.5) ++same;
    if (s.sign * (other - d) > 0.5) ++nearer;
  }
  return same == 2 ? Verdict::seen : nearer == 2 ? Verdict::hidden : Verdict::undecided;
}

}  // namespace

TEST_CASE("synthesis: at the truth images agree five times better than one pixel beside it") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Options options = small_scene(seed);
    options.bits = 0;
    options.sensor_noise = 0;
    const GeneratedScene scene = generate(options);
    for (const bool reverse : {false, true}) {
      const Photometry found = photometry(side(scene, reverse));
      CAPTURE(seed);
      CAPTURE(reverse);
      MESSAGE("seed ", seed, ": ", found.pixels, " pixels, mean difference ", found.error[1],
              " at the truth, ", found.error[0], " and ", found.error[2], " beside it");
      CHECK(found.pixels > 2000);
      CHECK(found.error[0] > 5 * found.error[1]);
      CHECK(found.error[2] > 5 * found.error[1]);
    }
  }
}

TEST_CASE("synthesis: masks are what a look from either view to the other finds") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Options options = small_scene(seed);
    options.samples = 1;
    for (const Interval interval : {Interval{0, 40}, Interval{-30, 11}}) {
      options.disparities = interval;
      const GeneratedScene scene = generate(options);
      for (const bool reverse : {false, true}) {
        const Side s = side(scene, reverse);
        int decided = 0, wrong = 0;
        for (int y = 0; y < s.truth.rows; ++y) {
          for (int x = 0; x < s.truth.cols; ++x) {
            const Verdict verdict = brute_force(s, y, x);
            if (verdict == Verdict::undecided) continue;
            ++decided;
            if ((verdict == Verdict::seen) != (s.visible(y, x) == 255)) ++wrong;
          }
        }
        CAPTURE(seed);
        CAPTURE(interval.begin);
        CAPTURE(reverse);
        CHECK(decided > 0.8 * static_cast<double>(s.truth.total()));
        // Tips of leaves, and gaps between them, may be narrower than a pixel.
        CHECK(wrong < 0.0005 * static_cast<double>(s.truth.total()));
      }
    }
  }
}

TEST_CASE("synthesis: on curved surfaces the two truths agree to a thousandth of a pixel") {
  int curved = 0, apart = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Options options = small_scene(seed);
    options.samples = 1;
    const GeneratedScene scene = generate(options);
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        if (scene.non_occluded(y, x) == 0) continue;
        const double d = static_cast<double>(scene.truth(y, x));
        const int left = static_cast<int>(std::floor(x - d));
        if (left < 2 || left + 3 >= 320) continue;
        std::array<double, 6> r{};  // columns left - 2 to left + 3
        for (int k = 0; k < 6; ++k)
          r[static_cast<std::size_t>(k)] =
              static_cast<double>(scene.reverse_truth(y, left - 2 + k));
        const double fourth = std::max(std::abs(r[0] - 4 * r[1] + 6 * r[2] - 4 * r[3] + r[4]),
                                       std::abs(r[1] - 4 * r[2] + 6 * r[3] - 4 * r[4] + r[5]));
        if (std::abs(r[2] + d) > 0.5) continue;  // what is seen is narrower than a pixel
        const double second = std::abs(r[1] - 2 * r[2] + r[3]);
        // One surface, not near its rim, and bent more than a straight line could follow.
        if (fourth > 2e-4 || second < 2e-3) continue;
        const double t = x - d - left;
        const double cubic = -t * (t - 1) * (t - 2) / 6 * r[1] +
                             (t + 1) * (t - 1) * (t - 2) / 2 * r[2] -
                             (t + 1) * t * (t - 2) / 2 * r[3] + (t + 1) * t * (t - 1) / 6 * r[4];
        ++curved;
        if (std::abs(cubic + d) > 1e-3) ++apart;
      }
    }
  }
  CHECK(curved > 10000);
  CHECK(apart <= 2);  // where a wire pierces a surface, narrower than a pixel
}

TEST_CASE("synthesis: disparities lie in the range, on both sides of zero or not, and differ") {
  for (const Interval interval :
       {Interval{0, 64}, Interval{-64, 0}, Interval{-5, 6}, Interval{300, 301}, Interval{0, 300}}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Options options = small_scene(seed);
      options.samples = 1;
      options.disparities = interval;
      options.faults.vertical = {0.01, -0.02, 5};
      const GeneratedScene scene = generate(options);
      double low = 0, high = 0, low_reverse = 0, high_reverse = 0;
      cv::minMaxLoc(scene.truth, &low, &high);
      cv::minMaxLoc(scene.reverse_truth, &low_reverse, &high_reverse);
      CAPTURE(seed);
      CAPTURE(interval.begin);
      CHECK(std::min(low, -high_reverse) >= interval.begin - 1e-4);
      CHECK(std::max(high, -low_reverse) <= interval.end - 1 + 1e-4);
      CHECK(high - low >= 0.3 * (interval.size() - 1));
    }
  }
}

TEST_CASE("synthesis: calibration puts near what has the larger disparity, none behind the eye") {
  for (const Interval interval : {Interval{0, 64}, Interval{-64, 0}, Interval{7, 8}}) {
    Options options = small_scene(1);
    options.disparities = interval;
    const Calibration c = generate(options).calibration;
    CHECK(c.focal > 0);
    CHECK(c.baseline > 0);
    CHECK(interval.begin + c.doffs > 0);
  }
}
