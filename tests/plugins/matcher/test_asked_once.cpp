// SPDX-License-Identifier: Apache-2.0
// What equal matchers of a fusion would find alike is found once, and is what each would find.
#include <set>
#include <thread>

#include "plugins/matcher/fakes.hpp"
#include "xgm/stage/asked_once.hpp"

namespace xgm::testing::matchers {
namespace {

/// A matcher that holds one and does something with its question or its answer.
template <class Deed>
class Around final : public Matcher {
 public:
  struct Parameters {
    Slot<Matcher> matcher;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("matcher", p.matcher, "The matcher inside.");
  }
  explicit Around(Parameters parameters) : parameters_(std::move(parameters)) {}
  bool gives_reverse_map() const override { return parameters_.matcher->gives_reverse_map(); }
  MatchResult run(const MatchRequest& request, const Context& context) const override {
    return Deed()(parameters_.matcher, request, context);
  }

 private:
  Parameters parameters_;
};

/// Asks for fewer disparities.
struct Narrower {
  MatchResult operator()(const Slot<Matcher>& matcher, MatchRequest request,
                         const Context& context) const {
    Interval fewer = request.range.hull();
    --fewer.end;
    request.range = DisparityRange::uniform(request.range.size(), fewer);
    return matcher(context, request);
  }
};

/// Writes into the maps that it has been given.
struct Spoiler {
  MatchResult operator()(const Slot<Matcher>& matcher, const MatchRequest& request,
                         const Context& context) const {
    MatchResult result = matcher(context, request);
    result.forward.disparity.setTo(request.range.hull().begin + 3.0);
    result.forward.status.setTo(static_cast<int>(Status::filled));
    return result;
  }
};

/// Tells whether anything may be known of matchers inside.
struct Witness {
  static bool& saw() {
    static bool value = false;
    return value;
  }
  MatchResult operator()(const Slot<Matcher>& matcher, const MatchRequest& request,
                         const Context& context) const {
    saw() = context.asked_once() != nullptr;
    return matcher(context, request);
  }
};

const Registry& registry() {
  static const Registry made = [] {
    Registry all = Registry::with_builtins();
    all.add<FakeMatcher>("fake", "Remembers what it is asked.");
    all.add<FakeSearchRange>("fake", "Proposes one interval.");
    all.add<FakeConsistency>("fake", "Finds everything consistent.");
    all.add<Around<Narrower>>("narrower", "Asks for fewer disparities.");
    all.add<Around<Spoiler>>("spoiler", "Changes maps in place.");
    all.add<Around<Witness>>("witness", "Looks into its context.");
    return all;
  }();
  return made;
}

std::shared_ptr<const Matcher> fusion(const std::string& matchers) {
  return make_stage<Matcher>("{type: fusion, matchers: [" + matchers + "]}", registry());
}

MatchRequest request() {
  return {random_pair({12, 8}, 1), DisparityRange::uniform({12, 8}, {-2, 6}), {}};
}

int times_asked(const std::shared_ptr<const Matcher>& matcher, const MatchRequest& question) {
  asked().clear();
  matcher->run(question, Context{});
  return static_cast<int>(asked().size());
}

const std::string kLeftRight = "{type: left_right, consistency: fake, matcher: fake}";
const std::string kPyramid =
    "{type: pyramid, scale: 2, search_range: {type: fake, begin: -1, end: 2}, matcher: fake}";

TEST_CASE("equal matchers that are asked the same run once, wherever they stand in a fusion") {
  const struct {
    std::string matchers;
    int asked;
  } cases[] = {
      {"fake, fake, fake", 1},
      {"fake, {type: fake, offset: 0}", 1},
      {"fake, {type: filtered, matcher: fake, filters: [{type: median}]}", 1},
      {"fake, " + kLeftRight, 2},
      {kLeftRight + ", fake", 2},
      {kLeftRight + ", {type: left_right, matcher: fake}", 2},
      {kLeftRight + ", {type: filtered, matcher: " + kLeftRight + "}", 2},
      {kPyramid + ", {type: filtered, matcher: " + kPyramid + "}", 2},
      {"fake, {type: pyramid, scale: 1, matcher: fake}", 1},
      {"{type: fusion, matchers: [fake, fake]}, {type: fake, offset: 1}", 2},
      {"fake, {type: fusion, matchers: [fake, {type: fake, offset: 1}]}", 2},
      {"fake, {type: fusion, matchers: [" + kLeftRight + "]}", 2},
  };
  for (const auto& one : cases) {
    const std::string& matchers = one.matchers;
    const int count = one.asked;
    CAPTURE(matchers);
    CHECK(times_asked(fusion(matchers), request()) == count);
    MatchRequest both = request();
    both.reverse_range = DisparityRange::uniform({12, 8}, {-4, 1});
    CHECK(times_asked(fusion(matchers), both) == count);
    CHECK(times_asked(fusion(matchers), {both.pair.swapped(), both.range, {}}) == count);
  }
}

TEST_CASE("matchers run again for other parameters, another range and another view") {
  CHECK(times_asked(fusion("fake, {type: fake, offset: 1}"), request()) == 2);
  CHECK(times_asked(fusion("fake, {type: narrower, matcher: fake}"), request()) == 2);
  CHECK(times_asked(fusion(kLeftRight), request()) == 2);
  CHECK(times_asked(fusion("fake, " + kPyramid), request()) == 3);
  const std::string both = "{type: fake, reverse: true}";
  CHECK(times_asked(fusion(both + ", {type: narrower, matcher: " + both + "}"), request()) == 2);
}

TEST_CASE("a fusion in a pyramid runs equal matchers once on each level") {
  const std::string matcher =
      "{type: pyramid, scale: 4, search_range: {type: fake, begin: -1, "
      "end: 2}, matcher: {type: fusion, matchers: [" +
      kLeftRight + ", {type: left_right, matcher: fake}]}}";
  CHECK(times_asked(make_stage<Matcher>(matcher, registry()), request()) == 3 * 2);
}

TEST_CASE("two calls of a fusion know nothing of each other") {
  const auto matcher = fusion("fake, fake");
  CHECK(times_asked(matcher, request()) == 1);
  CHECK(times_asked(matcher, request()) == 1);
}

TEST_CASE("a fusion gives what its fuser makes of matchers that run alone, bit for bit") {
  const std::string one =
      "{type: semi_global, cost: census, penalty: constant, aggregation: mgm, refinement: "
      "parabola, confidence: peak_ratio}";
  const std::string checked = "{type: left_right, matcher: " + one + "}";
  const std::vector<std::string> members{
      checked, one, "{type: filtered, matcher: " + checked + ", filters: [{type: median}]}",
      "{type: pyramid, scale: 2, matcher: " + one + "}",
      "{type: filtered, matcher: " + one + ", filters: [{type: peak_removal}]}"};
  ImagePair pair = shifted_pair({64, 48}, 5, 3);
  pair.base.valid = random_mask(pair.size(), 0.1, 4);
  pair.match.valid = random_mask(pair.size(), 0.1, 5);
  for (const DisparityRange& range :
       {DisparityRange::uniform(pair.size(), {0, 12}), random_range(pair.size(), {0, 12}, 6)}) {
    const MatchRequest question{pair, range, {}};
    Candidates alone;
    std::string all;
    for (const std::string& member : members) {
      MatchResult result = stage<Matcher>(member)->run(question, Context{});
      alone.maps.push_back(std::move(result.forward));
      alone.others.push_back(std::move(result.reverse).value_or(DisparityMap{}));
      all += (all.empty() ? "" : ", ") + member;
    }
    const std::string fuser = "{type: median, tolerance: 1, support: 2}";
    const DisparityMap expected = stage<Fuser>(fuser)->run(alone, pair, Context{});
    const auto matcher =
        stage<Matcher>("{type: fusion, fuser: " + fuser + ", matchers: [" + all + "]}");
    CHECK(identical(matcher->run(question, Context{}).forward, expected));
  }
}

TEST_CASE("a matcher that changes the maps that it was given changes no others") {
  for (const std::string spoiled :
       {"{type: spoiler, matcher: fake}, fake, fake", "fake, {type: spoiler, matcher: fake}, fake",
        "fake, fake, {type: spoiler, matcher: fake}"}) {
    CAPTURE(spoiled);
    const DisparityMap map = fusion(spoiled)->run(request(), Context{}).forward;
    CHECK(cv::countNonZero(map.disparity == -2) == map.size().area());
  }
}

TEST_CASE("where no matcher is still to be asked again, nothing is kept") {
  const auto sees = [](const std::string& matchers) {
    fusion(matchers)->run(request(), Context{});
    return Witness::saw();
  };
  const std::string witness = "{type: witness, matcher: {type: fake, offset: 1}}";
  CHECK_FALSE(sees(witness));
  CHECK_FALSE(sees("fake, " + witness));
  CHECK_FALSE(sees("fake, fake, " + witness));
  CHECK(sees("fake, " + witness + ", fake"));
}

/// Shows the matchers that it holds.
class Holder final : public Matcher {
 public:
  using Parameters = SlotList<Matcher>;
  static void describe(Parameters& p, ParameterSet& set) { set.add("matchers", p, "Several."); }
  explicit Holder(Parameters p) : matchers(p.begin(), p.end()) {}
  MatchResult run(const MatchRequest&, const Context&) const override { return {}; }
  std::vector<Slot<Matcher>> matchers;
};

TEST_CASE("equal matchers of a file are one stage, others are not") {
  Registry all = Registry::with_builtins();
  all.add<FakeMatcher>("fake", "Remembers what it is asked.");
  all.add<Holder>("holder", "Holds matchers.");
  const auto made = make_stage<Matcher>(
      "{type: holder, matchers: [fake, {type: fake, reverse: false}, {type: fake, offset: 1}, "
      "{type: filtered, matcher: fake}]}",
      all);
  const auto& matchers = dynamic_cast<const Holder&>(*made).matchers;
  const Stage* const fake = &matchers[0].stage();
  CHECK(&matchers[1].stage() == fake);
  CHECK(&matchers[2].stage() != fake);
  CHECK(matchers[0].matchers() == std::set<const Stage*>{fake});
  CHECK(matchers[3].matchers() == std::set<const Stage*>{fake, &matchers[3].stage()});
}

TEST_CASE("runs at once of one fusion do not disturb each other") {
  const std::string one = "{type: semi_global, cost: census, penalty: constant, aggregation: sgm}";
  const auto matcher = stage<Matcher>("{type: fusion, matchers: [" + one +
                                      ", {type: left_right, matcher: " + one + "}]}");
  const auto answer = [&](std::uint64_t seed) {
    const ImagePair pair = shifted_pair({60, 40}, 3, seed);
    return matcher->run({pair, DisparityRange::uniform(pair.size(), {0, 9}), {}}, Context{})
        .forward;
  };
  const DisparityMap first = answer(1), second = answer(2);
  DisparityMap again[2];
  std::thread other([&] {
    for (int i = 0; i < 10; ++i) again[0] = answer(1);
  });
  for (int i = 0; i < 10; ++i) again[1] = answer(2);
  other.join();
  CHECK(identical(again[0], first));
  CHECK(identical(again[1], second));
}

}  // namespace
}  // namespace xgm::testing::matchers
