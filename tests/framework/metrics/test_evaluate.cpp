// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/metrics.hpp"

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
                       random.integer(0, 1) ? Status::valid : Status::filled);
      }
      result.truth(y, x) =
          random.integer(0, 4) ? static_cast<float>(random.integer(-40, 40)) / 4 : kNan;
      constexpr std::array<uchar, 3> kValues = {0, 128, 255};
      result.mask(y, x) = kValues[static_cast<std::size_t>(random.integer(0, 2))];
    }
  }
  return result;
}

}  // namespace

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
