// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/plugins/maps.hpp"
#include "tests/support/simd.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::AggregatedVolume;
using xgm::DisparityMap;
using xgm::Status;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Slices of up to `longest` cells. What lies behind them is random, too: nobody may look at it.
AggregatedVolume random_sums(cv::Size size, int values, double no_match_share, std::uint64_t seed,
                             int longest = 11) {
  xgm::testing::Random random(seed);
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      begin(y, x) = random.integer(-10, 9);
      end(y, x) = begin(y, x) + random.integer(0, longest);  // some are empty
    }
  }
  const auto shape = std::make_shared<const xgm::VolumeShape>(xgm::DisparityRange(begin, end));
  AggregatedVolume sums(shape, 0);
  for (std::int64_t i = 0; i < shape->cells(); ++i) {
    const bool none = random.real(0, 1) < no_match_share;
    sums.data()[i] = none ? AggregatedVolume::kNoMatch
                          : static_cast<std::uint16_t>(random.integer(1000, 999 + values));
  }
  return sums;
}

/// S(p, d) as the definition sees it: infinite where there is no match.
double sum_at(const AggregatedVolume& sums, int y, int x, int d) {
  const auto cell = sums.at(y, x)[d - sums.shape().begin(y, x)];
  return cell == AggregatedVolume::kNoMatch ? kInfinity : static_cast<double>(cell);
}

DisparityMap oracle(const AggregatedVolume& sums, int uniqueness) {
  const auto& shape = sums.shape();
  DisparityMap map(shape.size(), Status::out_of_range);
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      double lowest = kInfinity, total = 0;
      int best = 0, n = 0;
      for (int d = shape.begin(y, x); d < shape.end(y, x); ++d) {
        const double s = sum_at(sums, y, x, d);
        if (std::isinf(s)) continue;
        ++n;
        total += s;
        if (s < lowest) {
          lowest = s;
          best = d;
        }
      }
      if (n == 0) continue;
      map.set(y, x, static_cast<float>(best));
      const double contrast = total / n - lowest;
      for (int d = shape.begin(y, x); d < shape.end(y, x); ++d) {
        const double s = sum_at(sums, y, x, d);
        if (uniqueness == 0 || std::isinf(s) || std::abs(d - best) <= 1) continue;
        if (s - lowest <= uniqueness / 100.0 * contrast + 1e-9) {
          map.invalidate(y, x, Status::ambiguous);
        }
      }
    }
  }
  return map;
}

AggregatedVolume one_pixel(const std::vector<int>& cells, int begin) {
  const int end = begin + static_cast<int>(cells.size());
  const auto shape =
      std::make_shared<const xgm::VolumeShape>(xgm::DisparityRange::uniform({1, 1}, {begin, end}));
  AggregatedVolume sums(shape, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sums.data()[i] = static_cast<std::uint16_t>(cells[i]);
  }
  return sums;
}

DisparityMap run(const std::string& yaml, const AggregatedVolume& sums) {
  return xgm::testing::stage<xgm::Selection>(yaml)->run(sums, xgm::Context{});
}

}  // namespace

TEST_CASE("wta is the argmin over the cells that can match") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int values : {1, 5, 30000}) {
      for (const double no_match : {0.0, 0.4, 1.0}) {
        CAPTURE(size);
        const auto sums = random_sums(size, values, no_match, 7);
        CHECK(xgm::testing::identical(run("wta", sums), oracle(sums, 0)));
      }
    }
  }
}

TEST_CASE("wta and its uniqueness are what they are with every SIMD target") {
  for (const int longest : {3, 40, 250, 70000}) {
    const cv::Size size = longest < 1000 ? cv::Size(37, 9) : cv::Size(3, 2);
    for (const int values : {2, 40, 64535}) {
      for (const double no_match : {0.0, 0.2, 0.97}) {
        const auto sums = random_sums(size, values, no_match, 9, longest);
        for (const int uniqueness : {0, 2, 30, 100}) {
          CAPTURE(longest);
          CAPTURE(uniqueness);
          const DisparityMap expected = oracle(sums, uniqueness);
          const std::string yaml = "{type: wta, uniqueness: " + std::to_string(uniqueness) + "}";
          xgm::testing::with_each_simd_target(
              [&] { CHECK(xgm::testing::identical(run(yaml, sums), expected)); });
        }
      }
    }
  }
}

TEST_CASE("wta takes the smallest of equal disparities, negative ones too") {
  const DisparityMap map = run("wta", one_pixel({9, 4, 7, 4, 4}, -6));
  CHECK(map.disparity(0, 0) == -5.0F);
  CHECK(map.at(0, 0) == Status::matched);
}

TEST_CASE("wta says out_of_range where nothing can match") {
  CHECK(run("wta", one_pixel({65535, 65535}, 0)).at(0, 0) == Status::out_of_range);
  CHECK(run("wta", one_pixel({}, 0)).at(0, 0) == Status::out_of_range);
}

TEST_CASE("wta accepts the largest sum that is a match") {
  CHECK(run("wta", one_pixel({65535, 65534, 65535}, 0)).disparity(0, 0) == 1.0F);
}

TEST_CASE("uniqueness is the test of its definition") {
  for (const int uniqueness : {1, 15, 60, 100}) {
    for (const int values : {3, 30000}) {
      CAPTURE(uniqueness);
      const auto sums = random_sums({40, 30}, values, 0.2, 3);
      const auto map = run("{type: wta, uniqueness: " + std::to_string(uniqueness) + "}", sums);
      CHECK(xgm::testing::identical(map, oracle(sums, uniqueness)));
    }
  }
}

TEST_CASE("uniqueness does not see a constant added to a pixel's sums") {
  const std::string yaml = "{type: wta, uniqueness: 20}";
  const std::vector<int> unique{50, 10, 60, 90, 40}, ambiguous{50, 10, 60, 15, 40};
  for (const int constant : {0, 7, 50000}) {
    auto shifted = [constant](std::vector<int> cells) {
      for (int& cell : cells) cell += constant;
      return cells;
    };
    CHECK(run(yaml, one_pixel(shifted(unique), 0)).at(0, 0) == Status::matched);
    CHECK(run(yaml, one_pixel(shifted(ambiguous), 0)).at(0, 0) == Status::ambiguous);
  }
}

TEST_CASE("uniqueness ignores the neighbours of the best and rejects flat sums") {
  const std::string yaml = "{type: wta, uniqueness: 1}";
  CHECK(run(yaml, one_pixel({10, 10}, 0)).at(0, 0) == Status::matched);
  CHECK(run(yaml, one_pixel({11, 10, 11, 90}, 0)).at(0, 0) == Status::matched);
  CHECK(run(yaml, one_pixel({10, 10, 10, 10}, 0)).at(0, 0) == Status::ambiguous);
  CHECK(run(yaml, one_pixel({10, 65535, 65535}, 0)).at(0, 0) == Status::matched);
}
