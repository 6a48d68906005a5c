// SPDX-License-Identifier: Apache-2.0
// The matchers put together with real stages.
#include <cmath>

#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

std::string flat(const std::string& aggregation) {
  return "{type: left_right, consistency: lrrl, matcher: {type: semi_global, cost: census, "
         "penalty: {type: constant, p1: 10, p2: 60}, refinement: parabola, filters: [{type: "
         "median, window: 3}], aggregation: {type: " +
         aggregation + ", directions: 8}}}";
}

std::string pyramid(int scale, const std::string& search, const std::string& aggregation) {
  return "{type: pyramid, scale: " + std::to_string(scale) + ", search_range: " + search +
         ", matcher: " + flat(aggregation) + "}";
}

bool identical(const MatchResult& a, const MatchResult& b) {
  return testing::identical(a.forward, b.forward) && a.reverse && b.reverse &&
         testing::identical(*a.reverse, *b.reverse);
}

ImagePair masked_pair(cv::Size size) {
  ImagePair pair = shifted_pair(size, 6, 3, 3);
  pair.base.valid = random_mask(size, 0.1, 4);
  pair.match.valid = random_mask(size, 0.1, 5);
  return pair;
}

TEST_CASE("a pyramid of scale 1 equals the flat matcher exactly") {
  const cv::Size size(53, 37);
  for (const char* aggregation : {"sgm", "mgm"}) {
    const MatchRequest request{masked_pair(size), DisparityRange::uniform(size, {-5, 19}), {}};
    const auto a = stage<Matcher>(pyramid(1, "min_max", aggregation))->run(request, Context{});
    const auto b = stage<Matcher>(flat(aggregation))->run(request, Context{});
    CHECK(identical(a, b));
  }
}

TEST_CASE("range maps that say the same everywhere equal one range") {
  const cv::Size size(53, 37);
  for (const char* aggregation : {"sgm", "mgm"}) {
    for (const Interval interval : {Interval{-5, 19}, {-70, 80}}) {
      const auto matcher = stage<Matcher>(flat(aggregation));
      const DisparityRange map(cv::Mat1i(size, interval.begin), cv::Mat1i(size, interval.end));
      const Interval back{1 - interval.end, 1 - interval.begin};
      const DisparityRange reverse(cv::Mat1i(size, back.begin), cv::Mat1i(size, back.end));
      const ImagePair pair = masked_pair(size);
      const auto one = matcher->run({pair, DisparityRange::uniform(size, interval), {}}, {});
      CHECK(identical(matcher->run({pair, map, reverse}, Context{}), one));
    }
  }
}

TEST_CASE("a pyramid finds the shift of a textured pair at every scale") {
  for (const int shift : {-11, 0, 13}) {
    for (const char* search : {"min_max", "percentile", "median_window"}) {
      for (const int scale : {2, 4, 8}) {
        INFO("shift ", shift, ", ", search, ", scale ", scale);
        const cv::Size size(131, 77);
        const MatchRequest request{
            shifted_pair(size, shift, 9), DisparityRange::uniform(size, {-24, 25}), {}};
        const auto map =
            stage<Matcher>(pyramid(scale, search, "sgm"))->run(request, Context{}).forward;
        int right = 0;
        for (int y = 0; y < size.height; ++y) {
          for (int x = 30; x < 100; ++x) {
            right += map.has_disparity(y, x) && std::abs(map.disparity(y, x) - float(shift)) < 0.5F;
          }
        }
        CHECK(right > 0.95 * 70 * 77);
      }
    }
  }
}

TEST_CASE("a pyramid keeps every disparity within half a pixel of its limits") {
  const cv::Size size(61, 45);
  const auto limits = random_range(size, {-9, 14}, 8);
  const auto map = stage<Matcher>(pyramid(8, "min_max", "mgm"))
                       ->run({masked_pair(size), limits, {}}, Context{})
                       .forward;
  int outside = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (!map.has_disparity(y, x) || limits.at(y, x).empty()) continue;
      // The median filter may carry a neighbour's disparity over; none leaves the hull.
      const float d = map.disparity(y, x);
      outside += d < float(limits.hull().begin) - 0.5F || d > float(limits.hull().end) - 0.5F;
    }
  }
  CHECK(outside == 0);
}

TEST_CASE("pyramids of tiny images run and answer every pixel") {
  for (const cv::Size size : {cv::Size(1, 1), {2, 3}, {1, 40}, {40, 1}, {5, 5}}) {
    for (const char* search : {"min_max", "percentile", "median_window"}) {
      const MatchRequest request{
          random_pair(size, 1), DisparityRange::uniform(size, {-9, 300}), {}};
      const auto result = stage<Matcher>(pyramid(64, search, "mgm"))->run(request, Context{});
      CHECK(result.forward.size() == size);
      CHECK(result.reverse->size() == size);
    }
  }
}

TEST_CASE("a pyramid does not depend on the number of threads") {
  const cv::Size size(67, 41);
  for (const char* search : {"min_max", "percentile", "median_window"}) {
    const auto matcher = stage<Matcher>(pyramid(4, search, "mgm"));
    const MatchRequest request{masked_pair(size), random_range(size, {-10, 30}, 3), {}};
    std::optional<MatchResult> first;
    for (const int count : {1, 2, 3, 8}) {
      const xgm::ThreadLimit threads(count);
      const MatchResult result = matcher->run(request, Context{});
      if (!first) first = result;
      CHECK(identical(result, *first));
    }
  }
}

}  // namespace
}  // namespace xgm::testing::matchers
