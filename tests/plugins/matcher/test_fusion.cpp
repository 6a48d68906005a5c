// SPDX-License-Identifier: Apache-2.0
#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

const MatchRequest& request() {
  static const MatchRequest made{random_pair({9, 5}, 1), DisparityRange::uniform({9, 5}, {-2, 7}),
                                 DisparityRange::uniform({9, 5}, {-6, 1})};
  return made;
}

TEST_CASE("fusion asks each of its matchers the same") {
  const auto matcher =
      matcher_with_fakes("{type: fusion, matchers: [fake, {type: fake, offset: 1}]}");
  matcher->run(request(), Context{});
  REQUIRE(asked().size() == 2);
  CHECK(asked()[0].path == "matchers[0]");
  CHECK(asked()[1].path == "matchers[1]");
  for (const Asked& each : asked()) {
    CHECK(each.request.pair.base.planes[0].data == request().pair.base.planes[0].data);
    CHECK(same_range(each.request.range, request().range));
    CHECK(same_range(*each.request.reverse_range, *request().reverse_range));
  }
}

TEST_CASE("fusion fuses the maps of its matchers") {
  const auto matcher = matcher_with_fakes(
      "{type: fusion, matchers: [fake, {type: fake, offset: 5}, {type: fake, offset: 5}]}");
  const MatchResult result = matcher->run(request(), Context{});
  CHECK(result.forward.disparity(2, 3) == 3);
  CHECK_FALSE(result.reverse);
}

TEST_CASE("fusion of one matcher is that matcher, both views and masks included") {
  for (const std::string one :
       {"{type: semi_global, cost: census, penalty: constant, aggregation: sgm}",
        "{type: left_right, matcher: {type: semi_global, cost: census, penalty: constant, "
        "aggregation: sgm}}"}) {
    CAPTURE(one);
    ImagePair pair = shifted_pair({40, 30}, 4, 3);
    pair.base.valid = random_mask(pair.size(), 0.1, 4);
    pair.match.valid = random_mask(pair.size(), 0.1, 5);
    const MatchRequest whole{pair, DisparityRange::uniform(pair.size(), {0, 9}), {}};
    const MatchResult alone = stage<Matcher>(one)->run(whole, Context{});
    const MatchResult fused =
        stage<Matcher>("{type: fusion, matchers: [" + one + "]}")->run(whole, Context{});
    CHECK(identical(fused.forward, alone.forward));
    REQUIRE(fused.reverse.has_value() == alone.reverse.has_value());
    if (alone.reverse) CHECK(identical(*fused.reverse, *alone.reverse));
  }
}

TEST_CASE("fusion gives a reverse map if all of its matchers do") {
  const auto gives = [](const std::string& matchers) {
    const auto matcher = matcher_with_fakes("{type: fusion, matchers: [" + matchers + "]}");
    CHECK(matcher->gives_reverse_map() == matcher->run(request(), Context{}).reverse.has_value());
    return matcher->gives_reverse_map();
  };
  CHECK(gives("{type: fake, reverse: true}, {type: fake, reverse: true}"));
  CHECK_FALSE(gives("{type: fake, reverse: true}, fake"));
  CHECK_FALSE(gives("fake, fake"));
}

TEST_CASE("fusion accepts range maps if all of its matchers do") {
  CHECK(matcher_with_fakes("{type: fusion, matchers: [fake, fake]}")->accepts_range_maps());
  CHECK_FALSE(
      matcher_with_fakes("{type: fusion, matchers: [fake, {type: fake, range_maps: false}]}")
          ->accepts_range_maps());
}

TEST_CASE("fusion refuses no matchers, and another number than its fuser was made for") {
  CHECK_THROWS_WITH_AS(matcher_with_fakes("{type: fusion, matchers: []}"),
                       doctest::Contains("must have at least one matcher"), Error);
  CHECK_THROWS_WITH_AS(
      matcher_with_fakes("{type: fusion, matchers: [fake], fuser: {type: forest, costs: [census, "
                         "absolute_difference]}}"),
      doctest::Contains("must be as many as the fuser was made for"), Error);
}

TEST_CASE("filtered runs its filters on the maps of both views, in their order") {
  const auto matcher = matcher_with_fakes(
      "{type: filtered, matcher: {type: fake, reverse: true}, filters: [{type: peak_removal, "
      "min_size: 100}, {type: median}]}");
  const MatchResult result = matcher->run(request(), Context{});
  REQUIRE(result.reverse);
  CHECK(result.forward.at(2, 3) == Status::peak);
  CHECK(result.reverse->at(2, 3) == Status::peak);
}

TEST_CASE("filtered without filters is its matcher") {
  const auto with = matcher_with_fakes("{type: filtered, matcher: {type: fake, reverse: true}}");
  const MatchResult expected =
      matcher_with_fakes("{type: fake, reverse: true}")->run(request(), Context{});
  const MatchResult result = with->run(request(), Context{});
  CHECK(identical(result.forward, expected.forward));
  CHECK(identical(*result.reverse, *expected.reverse));
  CHECK(with->gives_reverse_map());
  CHECK_FALSE(matcher_with_fakes("{type: filtered, matcher: {type: fake, range_maps: false}}")
                  ->accepts_range_maps());
}

}  // namespace
}  // namespace xgm::testing::matchers
