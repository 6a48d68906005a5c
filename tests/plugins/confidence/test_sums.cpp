// SPDX-License-Identifier: Apache-2.0
// Confidences that read sums, beside their definitions written plainly.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr int kNone = AggregatedVolume::kNoMatch;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Sums by disparity; cells outside of the range are not there, others may not match.
struct Pixel {
  std::vector<int> sums;
  int winner;  ///< index

  std::optional<double> at(int i) const {
    if (i < 0 || i >= static_cast<int>(sums.size()) || sums[std::size_t(i)] == kNone) return {};
    return sums[std::size_t(i)];
  }
  /// The lowest sum at least two disparities from the winner.
  std::optional<double> rival() const {
    std::optional<double> lowest;
    for (int i = 0; i < static_cast<int>(sums.size()); ++i) {
      if (std::abs(i - winner) < 2 || !at(i)) continue;
      lowest = std::min(lowest.value_or(kNone), *at(i));
    }
    return lowest;
  }
};

double peak_ratio(const Pixel& pixel) {
  const auto rival = pixel.rival();
  if (!rival) return 1;
  return *rival > 0 ? std::max(0.0, 1 - *pixel.at(pixel.winner) / *rival) : 0;
}

double margin(const Pixel& pixel) {
  const auto rival = pixel.rival();
  if (!rival) return 1;
  const double lead = std::max(0.0, *rival - *pixel.at(pixel.winner)) / 4;  // two fraction bits
  return lead / (lead + 30);
}

double curvature(const Pixel& pixel) {
  const auto before = pixel.at(pixel.winner - 1), after = pixel.at(pixel.winner + 1);
  if (!before && !after) return kNaN;
  const double sides = before.value_or(after.value_or(0)) + after.value_or(before.value_or(0));
  const double curved = std::max(0.0, sides - 2 * *pixel.at(pixel.winner)) / 4;
  return curved / (curved + 30);
}

struct Scene {
  AggregatedVolume sums;
  DisparityMap map;

  Evidence evidence() const {
    static const ImagePair none;
    return {none, map, &sums};
  }
  Pixel pixel(int y, int x, int winner) const {
    const auto cells = sums.cells(y, x);
    return {{cells.begin(), cells.end()}, winner - sums.shape().begin(y, x)};
  }
};

Scene random_scene(cv::Size size, int values, std::uint64_t seed) {
  const auto shape = std::make_shared<const VolumeShape>(random_range(size, {-9, 12}, seed));
  AggregatedVolume sums(shape, 2);
  Random random(seed);
  for (std::int64_t i = 0; i < shape->cells(); ++i) {
    const int value = random.integer(0, 7) == 0 ? kNone : random.integer(0, values - 1);
    sums.data()[i] = static_cast<std::uint16_t>(value);
  }
  DisparityMap map = stage<Selection>("wta")->run(sums, {});
  return {std::move(sums), std::move(map)};
}

void check_against(const std::string& yaml, const std::function<double(const Pixel&)>& oracle) {
  const auto confidence = stage<Confidence>(yaml);
  for (const cv::Size size : kMapSizes) {
    for (const int values : {3, 60000}) {
      const Scene scene = random_scene(size, values, 17);
      const cv::Mat1f found = confidence->run(scene.evidence(), {});
      REQUIRE(found.size() == size);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const double expected =
              scene.map.has_disparity(y, x)
                  ? oracle(scene.pixel(y, x, static_cast<int>(scene.map.disparity(y, x))))
                  : kNaN;
          REQUIRE(std::isnan(found(y, x)) == std::isnan(expected));
          if (!std::isnan(expected))
            REQUIRE(found(y, x) == doctest::Approx(expected).epsilon(1e-6));
        }
      }
    }
  }
}

/// Of one pixel that searches the disparities from `begin` on.
float confidence_of(const std::string& yaml, const std::vector<int>& values, int begin, float d,
                    Status status = Status::matched) {
  const Interval range{begin, begin + static_cast<int>(values.size())};
  AggregatedVolume sums(std::make_shared<const VolumeShape>(DisparityRange::uniform({1, 1}, range)),
                        0);
  std::copy(values.begin(), values.end(), sums.at(0, 0));
  DisparityMap map({1, 1});
  map.set(0, 0, d, status);
  return stage<Confidence>(yaml)->run({ImagePair{}, map, &sums}, {})(0, 0);
}

}  // namespace

TEST_CASE("peak_ratio is the lead over the best rival as a share of the rival's sum") {
  check_against("peak_ratio", peak_ratio);
}

TEST_CASE("maximum_margin is the lead over the best rival in costs") {
  check_against("{type: maximum_margin, half: 30}", margin);
}

TEST_CASE("curvature is the second difference at the winner, one-sided at the ends") {
  check_against("{type: curvature, half: 30}", curvature);
}

TEST_CASE("confidences find the winner of a disparity that was refined") {
  const std::vector<int> sums{90, 40, 10, 30, 80, 50};
  const float whole = confidence_of("peak_ratio", sums, 3, 5);
  CHECK(whole == doctest::Approx(0.8));  // the rival is 50, two and more from the winner
  CHECK(confidence_of("peak_ratio", sums, 3, 4.6F) == whole);
  CHECK(confidence_of("peak_ratio", sums, 3, 5.5F) == whole);
  CHECK(confidence_of("curvature", sums, 3, 5.25F) == confidence_of("curvature", sums, 3, 5));
}

TEST_CASE("confidences of sums have nothing to say of what was not matched, or not by these sums") {
  for (const char* yaml : {"peak_ratio", "maximum_margin", "curvature"}) {
    const std::string name = yaml;
    CAPTURE(name);
    const std::vector<int> sums{9, 1, 9, 8};
    CHECK(std::isfinite(confidence_of(yaml, sums, 0, 1)));
    CHECK(std::isnan(confidence_of(yaml, sums, 0, 1, Status::filled)));
    for (const float outside : {-1.0F, 4.0F, 1e9F, -1e9F}) {
      CHECK(std::isnan(confidence_of(yaml, sums, 0, outside)));
    }
    CHECK(std::isnan(confidence_of(yaml, {kNone, kNone}, 0, 1)));
  }
}

TEST_CASE("a winner that others beat is not sure at all") {
  CHECK(confidence_of("peak_ratio", {5, 9, 5, 9, 9, 2}, 0, 1) == 0);
  CHECK(confidence_of("maximum_margin", {5, 9, 5, 9, 9, 2}, 0, 1) == 0);
  CHECK(confidence_of("curvature", {5, 9, 5}, 0, 1) == 0);
  CHECK(confidence_of("peak_ratio", {0, 1, 0}, 0, 0) == 0);  // 0 / 0
}
