// SPDX-License-Identifier: Apache-2.0
// Confidences in matchers: what they are given, what becomes of them, and which are refused where.
#include <cmath>

#include "plugins/maps.hpp"
#include "plugins/matcher/fakes.hpp"
#include "xgm/base/error.hpp"

namespace xgm::testing::matchers {
namespace {

const char* const kSemiGlobal =
    "{type: semi_global, cost: census, penalty: constant, aggregation: sgm, refinement: parabola";

std::string semi_global(const std::string& more) { return kSemiGlobal + more + "}"; }

MatchRequest request_of(int disparity) {
  const ImagePair pair = shifted_pair({48, 32}, disparity, 5);
  return {pair, DisparityRange::uniform(pair.size(), {0, 16}), std::nullopt};
}

/// Judges the first half of the columns 1 and the others 0, and remembers what it was given.
struct Given {
  bool has_sums, has_other, has_confidence, is_reverse;
  std::string path;
  View view;
};
std::vector<Given>& given() {
  static std::vector<Given> all;
  return all;
}
class FakeConfidence final : public Confidence {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit FakeConfidence(Parameters) {}
  cv::Mat1f run(const Evidence& evidence, const Context& context) const override {
    given().push_back({evidence.sums != nullptr, evidence.other != nullptr,
                       !evidence.map.confidence.empty(), evidence.pair.is_reverse, context.path(),
                       context.place().view});
    cv::Mat1f confidence(evidence.map.size(), 0.0F);
    confidence.colRange(0, confidence.cols / 2) = 1;
    return confidence;
  }
};

/// Fills every hole with disparity 3.
class Fill final : public Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Fill(Parameters) {}
  DisparityMap run(const DisparityMap& map, const ImagePair&, const Context&) const override {
    DisparityMap filled = map.clone();
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (!map.has_disparity(y, x)) filled.set(y, x, 3, Status::filled);
      }
    }
    return filled;
  }
};

const Registry& registry() {
  static const Registry all = [] {
    Registry with_more = with_fakes();
    with_more.add<FakeConfidence>("fake", "Remembers what it is given.");
    with_more.add<Fill>("fill", "Fills holes.");
    return with_more;
  }();
  return all;
}

std::shared_ptr<const Matcher> matcher(const std::string& yaml) {
  given().clear();
  return make_stage<Matcher>(yaml, registry());
}

std::string mistakes(const std::string& text) {
  return to_string(load_pipeline_text(text, "p.yaml", registry()).diagnostics);
}

void check_mistake(const std::string& pipeline, const std::string& place, const std::string& what) {
  const std::string told = mistakes(pipeline);
  INFO(told);
  CHECK(told.find(place) == 0);
  CHECK(told.find(what) != std::string::npos);
}

}  // namespace

TEST_CASE("semi_global judges the refined map by its sums, and filters hand that on") {
  const auto with = matcher(semi_global(", confidence: fake, filters: [{type: median}]"));
  CHECK(with->gives_confidence());
  const MatchRequest request = request_of(4);
  const DisparityMap map = with->run(request, {}).forward;
  REQUIRE(given().size() == 1);
  CHECK(given()[0].has_sums);
  CHECK_FALSE(given()[0].has_other);
  CHECK_FALSE(given()[0].has_confidence);
  CHECK(given()[0].path == "confidence");
  REQUIRE(map.confidence.size() == map.size());
  CHECK(map.confidence(9, 10) == 1);
  CHECK(map.confidence(9, 40) == 0);
}

TEST_CASE("a confidence changes no disparity") {
  const MatchRequest request = request_of(4);
  const auto without = matcher(semi_global(""));
  CHECK_FALSE(without->gives_confidence());
  const DisparityMap expected = without->run(request, {}).forward;
  CHECK(expected.confidence.empty());
  const DisparityMap map =
      matcher(semi_global(", confidence: peak_ratio"))->run(request, {}).forward;
  CHECK(identical(map, expected));
}

TEST_CASE("what is filled after matching has no confidence") {
  const auto with = matcher(
      semi_global(", confidence: fake, filters: [{type: peak_removal, min_size: 5000}, fill]"));
  const DisparityMap map = with->run(request_of(4), {}).forward;
  REQUIRE(map.at(9, 10) == Status::filled);
  CHECK(std::isnan(map.confidence(9, 10)));
}

TEST_CASE("left_right judges both maps once they are checked, with what is known so far") {
  const auto both =
      matcher("{type: left_right, matcher: " + semi_global(", confidence: peak_ratio") +
              ", confidence: fake}");
  CHECK(both->gives_confidence());
  const MatchResult result = both->run(request_of(4), {});
  REQUIRE(given().size() == 2);
  for (const Given& call : given()) {
    CHECK_FALSE(call.has_sums);
    CHECK(call.has_other);
    CHECK(call.has_confidence);
  }
  CHECK(given()[0].path == "forward.confidence");
  CHECK(given()[1].path == "reverse.confidence");
  CHECK_FALSE(given()[0].is_reverse);
  CHECK(given()[1].is_reverse);
  CHECK(given()[0].view == View::forward);
  CHECK(given()[1].view == View::reverse);
  CHECK(result.forward.confidence(9, 10) == 1);
  CHECK(result.reverse->confidence(9, 40) == 0);
}

TEST_CASE(
    "left_right without a confidence hands that of its matcher on, but of what it took away") {
  const auto both =
      matcher("{type: left_right, matcher: " + semi_global(", confidence: fake") + "}");
  CHECK(both->gives_confidence());
  const DisparityMap map = both->run(request_of(4), {}).forward;
  REQUIRE(map.confidence.size() == map.size());
  int lost = 0;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      CHECK(std::isfinite(map.confidence(y, x)) == map.has_disparity(y, x));
      lost += map.has_disparity(y, x) ? 0 : 1;
    }
  }
  CHECK(lost > 0);
}

TEST_CASE("pyramids give the confidence of their last level") {
  const auto pyramid =
      matcher("{type: pyramid, scale: 2, matcher: " + semi_global(", confidence: fake") + "}");
  CHECK(pyramid->gives_confidence());
  const DisparityMap map = pyramid->run(request_of(4), {}).forward;
  CHECK(map.confidence.size() == map.size());
}

TEST_CASE("confidences are refused where the evidence that they need is missing") {
  check_mistake("xgm: 1\nmatcher: " + semi_global(", confidence: left_right_difference"),
                "p.yaml:2:", "needs the map of the other view");
  check_mistake("xgm: 1\nmatcher: " + semi_global(", confidence: so_far"),
                "p.yaml:2:", "needs a confidence that the map has already");
  const std::string left_right = "xgm: 1\nmatcher:\n  type: left_right\n";
  check_mistake(left_right + "  matcher: " + semi_global("") + "\n  confidence: curvature",
                "p.yaml:5:15", "needs the sums");
  check_mistake(left_right + "  matcher: " + semi_global("") + "\n  confidence: so_far",
                "p.yaml:5:15", "needs a confidence that maps have already");
  check_mistake(left_right + "  matcher: " + semi_global("") +
                    "\n  confidence: {type: weighted, confidences: [agreement, peak_ratio], "
                    "weights: [1, 1]}",
                "p.yaml:5:15", "needs the sums");
}

TEST_CASE("filters that need a confidence are refused where there is none") {
  const std::string filter = "[{type: confidence_threshold, min: 0.5}]";
  check_mistake("xgm: 1\nmatcher: " + semi_global(", filters: " + filter),
                "p.yaml:2:", "needs a confidence");
  check_mistake("xgm: 1\nmatcher: " + semi_global("") + "\npostprocess: " + filter,
                "p.yaml:3:", "needs a confidence");
  CHECK(mistakes("xgm: 1\nmatcher: " + semi_global(", confidence: peak_ratio, filters: " + filter) +
                 "\npostprocess: " + filter) == "");
  const auto filtered = [&](const std::string& inner) {
    return "xgm: 1\nmatcher: {type: filtered, matcher: " + semi_global(inner) +
           ", filters: " + filter + "}\npostprocess: " + filter;
  };
  check_mistake(filtered(""), "p.yaml:2:", "needs a confidence");
  CHECK(mistakes(filtered(", confidence: peak_ratio")) == "");
}

TEST_CASE("filtered matchers give the confidence of what they filter") {
  const auto filtered = matcher("{type: filtered, matcher: " + semi_global(", confidence: fake") +
                                ", filters: [{type: median, window: 3}]}");
  CHECK(filtered->gives_confidence());
  const DisparityMap map = filtered->run(request_of(4), {}).forward;
  CHECK(map.confidence.size() == map.size());
}

}  // namespace xgm::testing::matchers
