// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/sparsification.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Row {
  cv::Mat1f errors;  ///< NaN: no disparity
  cv::Mat1f confidence;

  Sparsification judge(const EvaluationRules& rules) const {
    DisparityMap map(errors.size());
    for (int x = 0; x < errors.cols; ++x) {
      if (errors(x) == errors(x)) map.set(0, x, 7 + errors(x));
    }
    return sparsification(map, cv::Mat1f(errors.size(), 7.0f), confidence, rules);
  }
};

}  // namespace

// Sorted by confidence the errors are 0, 3, 0, 1, of which 3 is above 2 px. Of the first 1, 2, 3, 4
// pixels 0, 1/2, 1/3, 1/4 are bad: the mean is 13/48; at best 0, 0, 0, 1/4: 1/16. Their average
// errors are 0, 3/2, 1, 1: 7/8; at best 0, 0, 1/3, 1: 1/3.
TEST_CASE("sparsification: by hand") {
  const Row row{(cv::Mat1f(1, 5) << 1, 0, kNan, 3, 0), (cv::Mat1f(1, 5) << 6, 9, 10, 8, 7)};
  const Sparsification s = row.judge({.deltas = {2}});
  CHECK(s.pixels == 4);
  REQUIRE(s.bad.size() == 1);
  CHECK(s.bad[0].area == doctest::Approx(13.0 / 48).epsilon(1e-12));
  CHECK(s.bad[0].optimal_area == doctest::Approx(1.0 / 16).epsilon(1e-12));
  CHECK(s.average_error.area == doctest::Approx(7.0 / 8).epsilon(1e-12));
  CHECK(s.average_error.optimal_area == doctest::Approx(1.0 / 3).epsilon(1e-12));
  // 20 points: 5 to 25 % of 4 pixels are 1 pixel, 30 to 50 % are 2, ...
  REQUIRE(s.kept.size() == 20);
  CHECK(s.kept[4] == 0.25);
  CHECK(s.kept[5] == 0.5);
  CHECK(s.kept[19] == 1);
  CHECK(s.bad[0].value[4] == 0);
  CHECK(s.bad[0].value[9] == 0.5);
  CHECK(s.bad[0].value[19] == 0.25);
  CHECK(s.bad[0].optimal[14] == 0);
  CHECK(s.average_error.value[9] == 1.5);
}

TEST_CASE("sparsification: pixels without a finite confidence are the least sure") {
  const Row row{(cv::Mat1f(1, 2) << 5, 0), (cv::Mat1f(1, 2) << kNan, -100)};
  CHECK(row.judge({.deltas = {1}}).bad[0].value[0] == 0);
}

TEST_CASE("sparsification: a constant confidence leaves the share of bad pixels as it is") {
  const Row row{(cv::Mat1f(1, 5) << 5, 0, 5, 0, 0), cv::Mat1f(1, 5, 1.0f)};
  const SparsificationCurve curve = row.judge({.deltas = {1}}).bad[0];
  for (const double share : curve.value) CHECK(share == doctest::Approx(0.4));
  CHECK(curve.area == doctest::Approx(0.4));
}

TEST_CASE("sparsification: ties count as the mean over all orders of the tied pixels") {
  const Row row{(cv::Mat1f(1, 5) << 3, 0, 2, 1, 4), (cv::Mat1f(1, 5) << 1, 2, 1, 2, 1)};
  std::array<int, 5> order{};
  std::iota(order.begin(), order.end(), 0);
  double bad_area = 0, error_area = 0, orders = 0;
  do {
    bool falling = true;
    for (std::size_t i = 1; i < 5; ++i) {
      falling &= row.confidence(order[i - 1]) >= row.confidence(order[i]);
    }
    if (!falling) continue;
    orders += 1;
    double bad = 0, error = 0;
    for (std::size_t kept = 1; kept <= 5; ++kept) {
      bad += row.errors(order[kept - 1]) > 1.5f ? 1 : 0;
      error += row.errors(order[kept - 1]);
      bad_area += bad / static_cast<double>(kept) / 5;
      error_area += error / static_cast<double>(kept) / 5;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  REQUIRE(orders == 12);  // 2! 3!
  const Sparsification s = row.judge({.deltas = {1.5}});
  CHECK(s.bad[0].area == doctest::Approx(bad_area / orders).epsilon(1e-12));
  CHECK(s.average_error.area == doctest::Approx(error_area / orders).epsilon(1e-12));
}

TEST_CASE("sparsification: no bit depends on where in the image pixels lie") {
  xgm::testing::Random random(5);
  Row row{cv::Mat1f(1, 400), cv::Mat1f(1, 400)};
  for (float& error : row.errors) error = static_cast<float>(random.integer(0, 1000)) / 77;
  for (float& sure : row.confidence) sure = static_cast<float>(random.integer(0, 9));
  Row turned;
  cv::flip(row.errors, turned.errors, 1);
  cv::flip(row.confidence, turned.confidence, 1);
  const Sparsification a = row.judge({.deltas = {1}}), b = turned.judge({.deltas = {1}});
  CHECK(a.bad[0].area == b.bad[0].area);
  CHECK(a.average_error.area == b.average_error.area);
  CHECK(a.average_error.value == b.average_error.value);
  CHECK(a.average_error.optimal_area <= a.average_error.area);
}

TEST_CASE("sparsification: with the confidence of an oracle the curve is the optimal one") {
  const Row row{(cv::Mat1f(1, 4) << 3, 0, 2, 1), (cv::Mat1f(1, 4) << -3, 0, -2, -1)};
  const Sparsification s = row.judge({.deltas = {0.5, 1}});
  CHECK(s.average_error.value == s.average_error.optimal);
  CHECK(s.bad[0].area == s.bad[0].optimal_area);
  CHECK(s.bad[1].area == s.bad[1].optimal_area);
}

TEST_CASE("sparsification: nothing to judge is an error, for a region it is no line") {
  const DisparityMap empty({2, 1});
  const cv::Mat1f ones(1, 2, 1.0f);
  CHECK(contains(error_of([&] { sparsification(empty, ones, ones, {}); }), "no pixel"));
  CHECK(contains(error_of([&] { sparsification(empty, ones, cv::Mat1f(2, 2, 1.0f), {}); }),
                 "confidence is 2 x 2"));
  CHECK(sparsification_by_region(empty, {.disparity = ones}, ones, {}).empty());
  DisparityMap half({2, 1});
  half.set(0, 0, 1);
  const GroundTruth truth{.disparity = ones, .non_occluded = (cv::Mat1b(1, 2) << 255, 0)};
  const auto regions = sparsification_by_region(half, truth, ones, {});
  REQUIRE(regions.size() == 2);  // none of the occluded pixels has a disparity
  CHECK(regions[1].region == "non-occluded");
}
