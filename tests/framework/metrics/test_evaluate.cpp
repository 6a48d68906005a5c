// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/metrics.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Case {
  DisparityMap map;
  cv::Mat1f truth;
  cv::Mat1b mask;
};

Case random_case(cv::Size size, std::uint64_t seed) {
  xgm::testing::Random random(seed);
  Case result{DisparityMap(size), cv::Mat1f(size), cv::Mat1b(size)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      // Quarters: errors of exactly a threshold occur.
      if (random.integer(0, 4) > 0) {
        result.map.set(y, x, static_cast<float>(random.integer(-40, 40)) / 4,
                       random.integer(0, 1) ? Status::matched : Status::filled);
      }
      result.truth(y, x) =
          random.integer(0, 4) ? static_cast<float>(random.integer(-40, 40)) / 4 : kNan;
      constexpr std::array<uchar, 3> kValues = {0, 128, 255};
      result.mask(y, x) = kValues[static_cast<std::size_t>(random.integer(0, 2))];
    }
  }
  return result;
}

/// Pixels in a row; NaN = no disparity, no truth. The ninth is masked out.
//   truth      10   10  10  10  100  100   10  none  10   50
//   disparity  10 10.5   9  12  104  106 none     3  50 46.5
//   error       0   .5   1   2    4    6    -     - (40)  3.5
Case by_hand() {
  const cv::Mat1f truth = (cv::Mat1f(1, 10) << 10, 10, 10, 10, 100, 100, 10, kNan, 10, 50);
  const cv::Mat1f found = (cv::Mat1f(1, 10) << 10, 10.5, 9, 12, 104, 106, kNan, 3, 50, 46.5);
  Case result{DisparityMap({10, 1}), truth, cv::Mat1b(1, 10, 255)};
  result.mask(8) = 128;
  for (int x = 0; x < 10; ++x) {
    if (!std::isnan(found(x))) result.map.set(0, x, found(x));
  }
  return result;
}

}  // namespace

// Judged are 8 pixels: all but the one without truth and the masked one. One is invalid. Seven
// errors, sorted: 0, 0.5, 1, 2, 3.5, 4, 6; their sum is 17, that of their squares 69.5.
TEST_CASE("metrics: figures computed by hand") {
  const Case c = by_hand();
  const Evaluation e = evaluate(c.map, c.truth, {.deltas = {0.5, 1, 2, 4, 6}}, c.mask);
  CHECK(e.judged == 8);
  CHECK(e.invalid == 1.0 / 8);
  CHECK(e.coverage() == 7.0 / 8);
  CHECK(e.average_error == 17.0 / 7);
  CHECK(e.rms == std::sqrt(69.5 / 7));
  CHECK(e.a50 == 2);  // 4 of 7 errors are at most 2, 3 of 7 at most 1
  CHECK(e.a90 == 6);  // 6 of 7 are 86 %: too few
  CHECK(e.a95 == 6);
  CHECK(e.a99 == 6);
  // Above 3 px: 3.5 (7 % of 50), 4 (4 % of 100: no outlier), 6 (6 % of 100); and the invalid one.
  CHECK(e.d1 == 3.0 / 8);
  const std::array bad = {5, 4, 3, 1, 0};  // errors above 0.5, 1, 2, 4 and 6
  for (std::size_t i = 0; i < bad.size(); ++i) {
    CHECK(e.at[i].bad == bad[i] / 8.0);
    CHECK(e.at[i].total == (bad[i] + 1) / 8.0);
  }
}

// The errors times 4: 0, 2, 4, 8, 14, 16, 24.
TEST_CASE("metrics: scale multiplies errors, not thresholds nor shares of the truth") {
  const Case c = by_hand();
  const Evaluation e = evaluate(c.map, c.truth, {.deltas = {2, 14}, .scale = 4}, c.mask);
  CHECK(e.average_error == 68.0 / 7);
  CHECK(e.rms == doctest::Approx(4 * std::sqrt(69.5 / 7)));
  CHECK(e.a50 == 8);
  CHECK(e.at[0].bad == 5.0 / 8);
  CHECK(e.at[1].bad == 2.0 / 8);
  // Above 3 px and 5 % now also: 4 (10 % of the truth) and 8 (20 %); 16 is 4 % as before.
  CHECK(e.d1 == 5.0 / 8);
}

// 104 and 106 become 100, 9 becomes 10, each the truth: errors 0, 0, 0, 0, 0.5, 2, 3.5.
TEST_CASE("metrics: clip moves disparities to the last one included, and leaves holes alone") {
  const Case c = by_hand();
  const Evaluation e = evaluate(c.map, c.truth, {.deltas = {1}, .clip = {10, 101}}, c.mask);
  CHECK(e.invalid == 1.0 / 8);
  CHECK(e.average_error == 6.0 / 7);
  CHECK(e.at[0].bad == 2.0 / 8);
}

TEST_CASE("metrics: A50 to A99, RMS and D1 equal their definitions, written plainly") {
  const std::array shares = {0.50, 0.90, 0.95, 0.99};
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    const Case c = random_case({static_cast<int>(seed % 23) + 1, 9}, seed);
    std::vector<double> errors;
    double squares = 0, outliers = 0, judged = 0;
    for (int i = 0; i < static_cast<int>(c.truth.total()); ++i) {
      const int y = i / c.truth.cols, x = i % c.truth.cols;
      if (std::isnan(c.truth(y, x))) continue;
      judged += 1;
      const double truth = c.truth(y, x), error = std::fabs(c.map.disparity(y, x) - truth);
      const bool hole = std::isnan(c.map.disparity(y, x));
      if (hole || (error > 3 && error / std::fabs(truth) > 0.05)) outliers += 1;
      if (hole) continue;
      errors.push_back(error);
      squares += error * error;
    }
    if (errors.empty()) continue;
    const Evaluation e = evaluate(c.map, c.truth, {});
    CHECK(e.d1 == doctest::Approx(outliers / judged));
    CHECK(e.rms == doctest::Approx(std::sqrt(squares / static_cast<double>(errors.size()))));
    const std::array figures = {e.a50, e.a90, e.a95, e.a99};
    for (std::size_t i = 0; i < shares.size(); ++i) {
      // The smallest of the errors that enough of them do not exceed.
      double smallest = std::numeric_limits<double>::infinity();
      for (const double candidate : errors) {
        const auto within = std::count_if(errors.begin(), errors.end(),
                                          [&](double error) { return error <= candidate; });
        const double share = static_cast<double>(within) / static_cast<double>(errors.size());
        if (share >= shares[i]) smallest = std::min(smallest, candidate);
      }
      CHECK(figures[i] == smallest);
    }
  }
}

TEST_CASE("metrics: equal the definitions of section 4.2, written plainly") {
  const std::vector<double> deltas = {0.5, 1.0, 2.0};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Case c = random_case({9, 7}, seed);
    for (const bool masked : {false, true}) {
      double truth_pixels = 0, invalid = 0, both = 0, error_sum = 0;
      std::array<double, 3> bad{};
      for (int i = 0; i < 63; ++i) {
        const double truth = c.truth(i / 9, i % 9), d = c.map.disparity(i / 9, i % 9);
        if (std::isnan(truth) || (masked && c.mask(i / 9, i % 9) != 255)) continue;
        truth_pixels += 1;
        if (std::isnan(d)) {
          invalid += 1;
          continue;
        }
        both += 1;
        error_sum += std::fabs(d - truth);
        for (std::size_t k = 0; k < 3; ++k) {
          if (std::fabs(d - truth) > deltas[k]) bad[k] += 1;
        }
      }
      const Evaluation e =
          evaluate(c.map, c.truth, {.deltas = deltas}, masked ? c.mask : cv::Mat1b());
      CHECK(static_cast<double>(e.judged) == truth_pixels);
      CHECK(e.invalid == doctest::Approx(invalid / truth_pixels));
      CHECK(e.average_error == doctest::Approx(error_sum / both));
      REQUIRE(e.at.size() == 3);
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(e.at[k].bad == doctest::Approx(bad[k] / truth_pixels));
        CHECK(e.at[k].total == doctest::Approx((bad[k] + invalid) / truth_pixels));
        CHECK(e.at[k].total == e.invalid + e.at[k].bad);  // to the last bit
      }
    }
  }
}

TEST_CASE("metrics: an error of exactly delta is not bad") {
  DisparityMap map({1, 1});
  map.set(0, 0, 3);
  const EvaluationRules deltas{.deltas = {1.0}};
  CHECK(evaluate(map, cv::Mat1f(1, 1, 4.0f), deltas).at[0].bad == 0);
  CHECK(evaluate(map, cv::Mat1f(1, 1, 4.001f), deltas).at[0].bad == 1);
}

TEST_CASE("metrics: an empty map is all invalid, its average error unknown") {
  const EvaluationRules deltas{.deltas = {1.0}};
  const Evaluation e = evaluate(DisparityMap({2, 2}), cv::Mat1f(2, 2, 1.0f), deltas);
  CHECK(e.invalid == 1);
  CHECK(e.at[0].total == 1);
  CHECK(std::isnan(e.average_error));
}

TEST_CASE("metrics: another size, or nothing to judge by, is an error") {
  const DisparityMap map({2, 2});
  CHECK(contains(error_of([&] { evaluate(map, cv::Mat1f(2, 3, 1.0f), {}); }), "3 x 2"));
  CHECK(contains(error_of([&] { evaluate(map, cv::Mat1f(2, 2, kNan), {}); }), "no pixel"));
  CHECK(contains(error_of([&] { evaluate(map, cv::Mat1f(2, 2, 1.0f), {}, cv::Mat1b(2, 2, 128)); }),
                 "no pixel"));
  CHECK(contains(error_of([&] { evaluate(map, cv::Mat1f(2, 2, 1.0f), {}, cv::Mat1b(1, 2, 255)); }),
                 "mask"));
}
