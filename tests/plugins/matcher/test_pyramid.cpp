// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

cv::Size scaled(cv::Size size, int scale) {
  return {(size.width + scale - 1) / scale, (size.height + scale - 1) / scale};
}

/// Table 1 for one coarse pixel: the limits of all fine pixels below it, divided by the scale.
Interval naive_limits(const DisparityRange& fine, int scale, int coarse_y, int coarse_x) {
  double low = 1e9;
  double high = -1e9;
  for (int y = coarse_y * scale; y < (coarse_y + 1) * scale && y < fine.size().height; ++y) {
    for (int x = coarse_x * scale; x < (coarse_x + 1) * scale && x < fine.size().width; ++x) {
      if (fine.at(y, x).empty()) continue;
      low = std::min(low, std::floor(double(fine.at(y, x).begin) / scale));
      high = std::max(high, std::ceil(double(fine.at(y, x).end - 1) / scale));
    }
  }
  if (low > high) return {};
  return {static_cast<int>(low), static_cast<int>(high) + 1};
}

DisparityRange naive_limits(const DisparityRange& fine, int scale) {
  const cv::Size size = scaled(fine.size(), scale);
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Interval limits = naive_limits(fine, scale, y, x);
      begin(y, x) = limits.begin;
      end(y, x) = limits.end;
    }
  }
  return {begin, end};
}

struct NaivePixel {
  double value = 0;
  bool valid = false;
};

/// The mean of means: each level's valid pixels vote once.
NaivePixel naive_pixel(const Image& image, std::size_t plane, int scale, int y, int x) {
  if (y >= scaled(image.size(), scale).height || x >= scaled(image.size(), scale).width) return {};
  if (scale == 1) return {double(image.planes[plane](y, x)), image.is_valid(y, x)};
  NaivePixel sum;
  int voters = 0;
  for (const int v : {2 * y, 2 * y + 1}) {
    for (const int u : {2 * x, 2 * x + 1}) {
      const NaivePixel finer = naive_pixel(image, plane, scale / 2, v, u);
      if (!finer.valid) continue;
      sum.value += finer.value;
      ++voters;
    }
  }
  return {voters == 0 ? 0 : sum.value / voters, voters > 0};
}

int wrong_pixels(const Image& level, const Image& full, int scale) {
  int wrong = 0;
  for (std::size_t plane = 0; plane < full.planes.size(); ++plane) {
    for (int y = 0; y < level.size().height; ++y) {
      for (int x = 0; x < level.size().width; ++x) {
        const NaivePixel expected = naive_pixel(full, plane, scale, y, x);
        wrong += level.is_valid(y, x) != expected.valid;
        wrong += std::abs(double(level.planes[plane](y, x)) - expected.value) > 1e-4;
      }
    }
  }
  return wrong;
}

TEST_CASE("levels are repeated 2x2 means in which masked pixels do not vote") {
  for (const cv::Size size : {cv::Size(37, 21), {16, 8}, {5, 40}, {1, 1}, {3, 2}}) {
    for (const double masked : {0.0, 0.3, 0.9, 1.0}) {
      INFO(size.width, "x", size.height, ", masked ", masked);
      const auto matcher =
          matcher_with_fakes("{type: pyramid, scale: 8, matcher: {type: fake, reverse: true}}");
      ImagePair pair = random_pair(size, 5, 3);
      if (masked > 0) {
        pair.base.valid = random_mask(size, masked, 6);
        pair.match.valid = random_mask(size, masked, 7);
      }
      matcher->run({pair, DisparityRange::uniform(size, {0, 20}), {}}, Context{});
      REQUIRE(asked().size() == 4);
      for (std::size_t i = 0; i < 4; ++i) {
        const int scale = 8 >> i;
        const MatchRequest& level = asked()[i].request;
        CHECK(asked()[i].path == "s" + std::to_string(scale) + ".matcher");
        CHECK(level.pair.base.size() == scaled(size, scale));
        CHECK(level.range.size() == scaled(size, scale));
        CHECK(wrong_pixels(level.pair.base, pair.base, scale) == 0);
        CHECK(wrong_pixels(level.pair.match, pair.match, scale) == 0);
      }
    }
  }
}

TEST_CASE("the coarsest level searches the limits of Table 1") {
  const cv::Size size(37, 21);
  for (const Interval hull : {Interval{-29, 18}, {0, 70}, {3, 4}, {-8, -7}, {7, 9}}) {
    for (const int scale : {2, 4, 8, 64}) {
      INFO(hull.begin, ":", hull.end, " / ", scale);
      const auto matcher = matcher_with_fakes("{type: pyramid, scale: " + std::to_string(scale) +
                                              ", matcher: {type: fake, reverse: true}}");
      const auto uniform = DisparityRange::uniform(size, hull);
      matcher->run({random_pair(size, 1), uniform, {}}, Context{});
      CHECK(asked()[0].request.range.is_uniform());
      CHECK(same_range(asked()[0].request.range, naive_limits(uniform, scale)));

      asked().clear();
      const auto map = random_range(size, hull, 2);
      const auto reverse = random_range(size, {-hull.end + 1, -hull.begin + 1}, 3);
      matcher->run({random_pair(size, 1), map, reverse}, Context{});
      CHECK(same_range(asked()[0].request.range, naive_limits(map, scale)));
      CHECK(same_range(*asked()[0].request.reverse_range, naive_limits(reverse, scale)));
    }
  }
}

/// Whether every pixel's interval lies within its limits, and is empty only where these are.
bool within(const DisparityRange& range, const DisparityRange& limits) {
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) {
      const Interval inner = range.at(y, x);
      const Interval outer = limits.at(y, x);
      if (inner.empty() != outer.empty()) return false;
      if (!inner.empty() && !(intersect(inner, outer) == inner)) return false;
    }
  }
  return true;
}

TEST_CASE("no level leaves the limits, and none loses a pixel") {
  const cv::Size size(45, 30);
  const auto limits = random_range(size, {-40, 33}, 11);
  const auto reverse = random_range(size, {-32, 41}, 12);
  for (const char* search :
       {"min_max", "percentile", "median_window", "{type: fake, begin: -3, end: 2}",
        "{type: fake, begin: 90, end: 99}", "{type: min_max, relaxation: 0, window: 1}"}) {
    CAPTURE(search);
    const auto matcher = matcher_with_fakes(
        std::string("{type: pyramid, scale: 8, matcher: {type: fake, reverse: true, offset: 0.4}, "
                    "search_range: ") +
        search + "}");
    matcher->run({random_pair(size, 1), limits, reverse}, Context{});
    for (std::size_t i = 0; i < 4; ++i) {
      const int scale = 8 >> i;
      CHECK(within(asked()[i].request.range, naive_limits(limits, scale)));
      CHECK(within(*asked()[i].request.reverse_range, naive_limits(reverse, scale)));
    }
  }
}

TEST_CASE("finer levels search what the search_range stage says, within the limits") {
  const cv::Size size(11, 7);
  const auto run = [&](const char* search, Interval limits) {
    const auto matcher = matcher_with_fakes(
        std::string("{type: pyramid, scale: 2, matcher: fake, search_range: ") + search + "}");
    matcher->run({random_pair(size, 1), DisparityRange::uniform(size, limits), {}}, Context{});
    REQUIRE(asked().size() == 2);
    CHECK_FALSE(asked()[1].request.reverse_range);
    return asked()[1].request.range.hull();
  };
  CHECK(run("{type: fake, begin: 3, end: 6}", {0, 20}) == Interval{3, 6});
  CHECK(run("{type: fake, begin: -3, end: 6}", {0, 20}) == Interval{0, 6});
  CHECK(run("{type: fake, begin: 30, end: 36}", {0, 20}) == Interval{0, 20});  // do not meet
  CHECK_THROWS_WITH_AS(run("{type: fake, begin: 6, end: 6}", {0, 20}),
                       doctest::Contains("nothing to search"), Error);
  CHECK(run("{type: fake, begin: 3, end: 6}", {4, 4}).empty());
  // The fake answers 4 / 2 = 2 at the coarse level, so Eq. 7 asks for 4 - 4 to 4 + 4.
  CHECK(run("min_max", {4, 20}) == Interval{4, 9});
}

TEST_CASE("the reverse map narrows the reverse range") {
  const cv::Size size(40, 9);
  const auto matcher = matcher_with_fakes(
      "{type: pyramid, scale: 2, matcher: {type: fake, reverse: true}, search_range: {type: "
      "min_max, relaxation: 1}}");
  matcher->run({random_pair(size, 1), DisparityRange::uniform(size, {0, 31}), {}}, Context{});
  CHECK_FALSE(asked()[0].request.reverse_range);
  CHECK(asked()[1].request.range.hull() == Interval{0, 2});
  REQUIRE(asked()[1].request.reverse_range);
  CHECK(asked()[1].request.reverse_range->hull() == Interval{-30, -28});
}

TEST_CASE("a pyramid of scale 1 asks its matcher the same question") {
  const cv::Size size(7, 5);
  const auto matcher = matcher_with_fakes(
      "{type: pyramid, scale: 1, matcher: {type: fake, range_maps: false, reverse: true}}");
  const MatchRequest request{random_pair(size, 1), random_range(size, {-4, 9}, 2),
                             random_range(size, {-8, 5}, 3)};
  const MatchResult result = matcher->run(request, Context{});
  REQUIRE(asked().size() == 1);
  const MatchRequest& seen = asked()[0].request;
  CHECK(seen.pair.base.planes[0].data == request.pair.base.planes[0].data);
  CHECK(seen.pair.match.planes[0].data == request.pair.match.planes[0].data);
  CHECK(same_range(seen.range, request.range));
  CHECK(same_range(*seen.reverse_range, *request.reverse_range));
  REQUIRE(result.reverse);
  CHECK_FALSE(matcher->accepts_range_maps());
  CHECK(matcher->gives_reverse_map());
}

TEST_CASE("images smaller than the scale and ranges wider than the image work") {
  for (const cv::Size size : {cv::Size(1, 1), {1, 9}, {9, 1}, {5, 3}}) {
    for (const Interval hull : {Interval{-500, 300}, {7, 8}, {0, 0}}) {
      const auto matcher = matcher_with_fakes("{type: pyramid, scale: 64, matcher: fake}");
      const MatchResult result =
          matcher->run({random_pair(size, 1), DisparityRange::uniform(size, hull), {}}, Context{});
      REQUIRE(asked().size() == 7);
      CHECK(result.forward.size() == size);
      CHECK(result.forward.density() == (hull.empty() ? 0.0 : 1.0));
    }
  }
}

TEST_CASE("pyramid refuses scales that are no powers of two and matchers without range maps") {
  CHECK_THROWS_WITH_AS(matcher_with_fakes("{type: pyramid, scale: 6, matcher: fake}"),
                       doctest::Contains("give one of 1, 2, 4, 8"), Error);
  CHECK_THROWS_WITH_AS(
      matcher_with_fakes("{type: pyramid, matcher: {type: fake, range_maps: false}}"),
      doctest::Contains("needs one range for the whole image"), Error);
  CHECK_THROWS_WITH_AS(matcher_with_fakes("{type: pyramid, matcher: opencv_sgbm}"),
                       doctest::Contains("needs one range for the whole image"), Error);
}

TEST_CASE("progress of a pyramid never falls and ends at 1") {
  const cv::Size size(32, 16);
  const auto matcher = matcher_with_fakes(
      "{type: pyramid, scale: 8, matcher: {type: left_right, matcher: fake, consistency: fake}}");
  ProgressObserver observer;
  const MatchRequest request{random_pair(size, 1), DisparityRange::uniform(size, {0, 9}), {}};
  matcher->run(request, Context(&observer));
  REQUIRE_FALSE(observer.shares.empty());
  CHECK(std::is_sorted(observer.shares.begin(), observer.shares.end(),
                       [](double a, double b) { return a < b - 1e-12; }));
  CHECK(observer.shares.back() == doctest::Approx(1));
}

}  // namespace
}  // namespace xgm::testing::matchers
