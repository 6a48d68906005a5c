// SPDX-License-Identifier: Apache-2.0
// The truth of generated scenes is the truth of the pixels that they consist of.
#include "xgm/testing/synthetic.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/support.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

double bilinear(const cv::Mat1f& image, double x, double y) {
  const int x0 = std::clamp(static_cast<int>(std::floor(x)), 0, image.cols - 2);
  const int y0 = std::clamp(static_cast<int>(std::floor(y)), 0, image.rows - 2);
  const double s = x - x0, t = y - y0;
  return (1 - t) * ((1 - s) * image(y0, x0) + s * image(y0, x0 + 1)) +
         t * ((1 - s) * image(y0 + 1, x0) + s * image(y0 + 1, x0 + 1));
}

/// Median over the visible pixels of |base(x, y) - match(x - d + error_x, y + dy + error_y)|.
double median_difference(const SyntheticScene& scene, const VerticalShift& shift, double error_x,
                         double error_y) {
  std::vector<double> differences;
  const cv::Mat1f &base = scene.pair.base.planes[0], &match = scene.pair.match.planes[0];
  for (int y = 2; y < base.rows - 2; ++y) {
    for (int x = 2; x < base.cols - 2; ++x) {
      if (scene.non_occluded(y, x) == 0) continue;
      const double x_match = x - static_cast<double>(scene.truth(y, x));
      const double seen = bilinear(match, x_match + error_x, y + shift.at(x_match, y) + error_y);
      differences.push_back(std::abs(seen - static_cast<double>(base(y, x))));
    }
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

double share(const SyntheticScene& scene, bool visible,
             const std::function<bool(int y, int x)>& holds) {
  int all = 0, good = 0;
  for (int y = 0; y < scene.truth.rows; ++y) {
    for (int x = 0; x < scene.truth.cols; ++x) {
      if ((scene.non_occluded(y, x) != 0) != visible) continue;
      ++all;
      if (holds(y, x)) ++good;
    }
  }
  CHECK(all > 0);
  return static_cast<double>(good) / all;
}

std::uint64_t fnv(const cv::Mat& mat) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (int y = 0; y < mat.rows; ++y) {
    const auto* row = mat.ptr(y);
    for (std::size_t i = 0; i < static_cast<std::size_t>(mat.cols) * mat.elemSize(); ++i)
      hash = (hash ^ row[i]) * 0x100000001b3u;
  }
  return hash;
}

}  // namespace

TEST_CASE("synthetic: a scene of one disparity is a shift by whole pixels") {
  SceneOptions options;
  options.disparities = {-3, -2};
  const SyntheticScene scene = make_scene(options);
  int checked = 0;
  for (int y = 0; y < options.size.height; ++y) {
    for (int x = 0; x < options.size.width; ++x) {
      CHECK(scene.truth(y, x) == -3);
      CHECK((scene.non_occluded(y, x) != 0) == (x + 3 < options.size.width));
      if (scene.non_occluded(y, x) == 0) continue;
      ++checked;
      CHECK(scene.pair.match.planes[0](y, x + 3) == scene.pair.base.planes[0](y, x));
    }
  }
  CHECK(checked > 18000);
}

TEST_CASE("synthetic: truth points at the same texture in the match image, and nothing else does") {
  SceneOptions options;
  for (const Interval interval : {Interval{0, 32}, Interval{-40, -10}, Interval{-10, 12}}) {
    options.disparities = interval;
    const SyntheticScene scene = make_scene(options);
    const double right = median_difference(scene, {}, 0, 0);
    CHECK(right < 2.5);
    for (const double error : {-0.75, 0.75}) {
      CHECK(median_difference(scene, {}, error, 0) > 2 * right);
      CHECK(median_difference(scene, {}, 0, error) > 2 * right);
    }
  }
}

TEST_CASE("synthetic: rows are shifted as asked for") {
  SceneOptions options;
  options.shift = {0.01, -0.02, 1.7};
  const SyntheticScene scene = make_scene(options);
  const double right = median_difference(scene, options.shift, 0, 0);
  CHECK(right < 3);
  CHECK(median_difference(scene, {}, 0, 0) > 2 * right);
  CHECK(median_difference(scene, {0.01, 0.02, 1.7}, 0, 0) > 2 * right);
}

TEST_CASE("synthetic: disparities lie in the range and differ within it") {
  for (const Interval interval : {Interval{0, 64}, Interval{-64, 0}, Interval{-5, 6}}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SceneOptions options;
      options.disparities = interval;
      options.seed = seed;
      const SyntheticScene scene = make_scene(options);
      double low = 0, high = 0, low_reverse = 0, high_reverse = 0;
      cv::minMaxLoc(scene.truth, &low, &high);
      cv::minMaxLoc(scene.reverse_truth, &low_reverse, &high_reverse);
      CHECK(std::min(low, -high_reverse) >= interval.begin);
      CHECK(std::max(high, -low_reverse) <= interval.end - 1);
      CHECK(high - low > 0.3 * interval.size());
      CHECK(scene.disparities == interval);
    }
  }
}

TEST_CASE(
    "synthetic: both truths agree where a pixel is visible, and tell what hides it elsewhere") {
  SceneOptions options;
  options.size = {321, 203};
  options.disparities = {0, 50};
  const SyntheticScene scene = make_scene(options);
  const auto reverse = [&](int y, int x) {
    return bilinear(scene.reverse_truth, x - static_cast<double>(scene.truth(y, x)), y);
  };
  const double agreeing = share(scene, true, [&](int y, int x) {
    return std::abs(reverse(y, x) + static_cast<double>(scene.truth(y, x))) < 1e-3;
  });
  CHECK(agreeing > 0.97);  // the others straddle an edge of the match view
  const double hidden = share(scene, false, [&](int y, int x) {
    const double x_match = x - static_cast<double>(scene.truth(y, x));
    return x_match < 0 || x_match > options.size.width - 1 ||
           -reverse(y, x) > static_cast<double>(scene.truth(y, x)) + 1e-3;
  });
  CHECK(hidden > 0.97);
}

TEST_CASE("synthetic: exposure and noise are what the options say") {
  SceneOptions options;
  options.whole_levels = false;
  options.objects = 0;
  const SyntheticScene plain = make_scene(options);
  options.gain = 0.8;
  options.bias = 12;
  const SyntheticScene darker = make_scene(options);
  CHECK(cv::norm(plain.pair.base.planes[0], darker.pair.base.planes[0], cv::NORM_INF) == 0);
  cv::Mat1f expected;
  plain.pair.match.planes[0].convertTo(expected, CV_32F, 0.8, 12);
  CHECK(cv::norm(expected, darker.pair.match.planes[0], cv::NORM_INF) < 1e-3);
  options.noise = 5;
  cv::Scalar mean, deviation;
  cv::meanStdDev(make_scene(options).pair.base.planes[0] - plain.pair.base.planes[0], mean,
                 deviation);
  CHECK(std::abs(mean[0]) < 0.2);
  CHECK(std::abs(deviation[0] - 5) < 0.2);
}

TEST_CASE("synthetic: the same options give the same bytes, for any number of threads, anywhere") {
  SceneOptions options;
  options.colour = true;
  options.noise = 2;
  options.shift = {0.003, 0.002, -0.4};
  // Golden values: what this test prints when the generator is changed on purpose.
  for (const int count : {1, 3}) {
    const xgm::ThreadLimit threads(count);
    const SyntheticScene scene = make_scene(options);
    CHECK(fnv(scene.pair.base.planes[2]) == 7295878729626143590u);
    CHECK(fnv(scene.pair.match.planes[1]) == 7620033636260138947u);
    CHECK(fnv(scene.truth) == 5351649021910592765u);
    CHECK(fnv(scene.reverse_truth) == 16543233709757811741u);
  }
  options.seed = 2;
  CHECK(fnv(make_scene(options).truth) != 5351649021910592765u);
}

TEST_CASE("synthetic: any size and range will do, nothing does not") {
  SceneOptions options;
  options.size = {1, 1};
  options.disparities = {-100, 300};
  CHECK(make_scene(options).truth.size() == cv::Size(1, 1));
  options.disparities = {4, 4};
  CHECK_THROWS_AS(make_scene(options), Error);
  options.disparities = {0, 4};
  options.size = {0, 5};
  CHECK_THROWS_AS(make_scene(options), Error);
  options.size = {5, 5};
  options.shift.b = -1;
  CHECK_THROWS_AS(make_scene(options), Error);
}

TEST_CASE("synthetic: the sample pair is what the command line promises") {
  const SyntheticScene scene = xgm::synthesis::sample_pair();
  CHECK(scene.pair.size() == cv::Size(640, 480));
  CHECK(scene.pair.base.planes.size() == 3);
  CHECK(scene.disparities == Interval{0, 64});
  CHECK(cv::mean(scene.non_occluded)[0] > 0.85 * 255);
}
