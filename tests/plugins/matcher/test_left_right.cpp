// SPDX-License-Identifier: Apache-2.0
#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

const char* const kLeftRight = "{type: left_right, matcher: fake, consistency: fake}";

TEST_CASE("left_right asks its matcher about the pair and about the swapped pair") {
  const auto matcher = matcher_with_fakes(kLeftRight);
  const MatchRequest request{random_pair({9, 5}, 1), DisparityRange::uniform({9, 5}, {-2, 7}), {}};
  const MatchResult result = matcher->run(request, Context{});

  REQUIRE(asked().size() == 2);
  CHECK(asked()[0].path == "forward.matcher");
  CHECK(asked()[1].path == "reverse.matcher");
  CHECK(asked()[0].request.pair.base.planes[0].data == request.pair.base.planes[0].data);
  CHECK(asked()[1].request.pair.base.planes[0].data == request.pair.match.planes[0].data);
  CHECK(asked()[1].request.pair.match.planes[0].data == request.pair.base.planes[0].data);
  CHECK(asked()[0].request.range.hull() == Interval{-2, 7});
  CHECK(asked()[1].request.range.hull() == Interval{-6, 3});
  CHECK(asked()[1].request.range.is_uniform());
  CHECK(result.forward.disparity(2, 3) == -2.F);
  REQUIRE(result.reverse);
  CHECK(result.reverse->disparity(2, 3) == -6.F);
}

TEST_CASE("left_right uses the reverse range that it is given") {
  const auto matcher = matcher_with_fakes(kLeftRight);
  const auto forward = random_range({8, 6}, {0, 5}, 3);
  const auto reverse = random_range({8, 6}, {-9, 1}, 4);
  matcher->run({random_pair({8, 6}, 2), forward, reverse}, Context{});
  CHECK(same_range(asked()[0].request.range, forward));
  CHECK(same_range(asked()[1].request.range, reverse));
  matcher->run({random_pair({8, 6}, 2), forward, std::nullopt}, Context{});
  CHECK(same_range(asked()[3].request.range, forward.reversed()));
}

TEST_CASE("left_right refuses a matcher that already matches both views") {
  CHECK_THROWS_WITH_AS(
      matcher_with_fakes("{type: left_right, consistency: fake, matcher: {type: left_right, "
                         "consistency: fake, matcher: fake}}"),
      doctest::Contains("must be one that matches a single view"), Error);
  CHECK_THROWS_WITH_AS(
      matcher_with_fakes("{type: left_right, consistency: fake, matcher: {type: pyramid, matcher: "
                         "{type: fake, reverse: true}}}"),
      doctest::Contains("must be one that matches a single view"), Error);
}

TEST_CASE("left_right accepts range maps if its matcher does") {
  CHECK(matcher_with_fakes(kLeftRight)->accepts_range_maps());
  CHECK_FALSE(matcher_with_fakes("{type: left_right, consistency: fake, matcher: {type: fake, "
                                 "range_maps: false}}")
                  ->accepts_range_maps());
}

}  // namespace
}  // namespace xgm::testing::matchers
