// SPDX-License-Identifier: Apache-2.0
// What a stage of any kind returns is looked at: what would mislead others is an error that names
// path, plugin and rule.
#include <limits>

#include "framework/stage/doing.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const cv::Size kSize(12, 7);
const Interval kRange{0, 4};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

ImagePair pair_of_images() { return shifted_pair(kSize, 2, 1); }
DisparityRange range() { return DisparityRange::uniform(kSize, kRange); }
MatchRequest request() { return {pair_of_images(), range(), std::nullopt}; }

/// All pixels matched but (0, 0), which is occluded.
DisparityMap sound_map(float disparity = 2) {
  DisparityMap map(kSize);
  map.disparity.setTo(disparity);
  map.status.setTo(static_cast<int>(Status::matched));
  map.invalidate(0, 0, Status::occluded);
  return map;
}

AggregatedVolume sums() {
  AggregatedVolume sums(std::make_shared<const VolumeShape>(range()), 0);
  std::fill_n(sums.data(), sums.shape().cells(), std::uint16_t{1});
  return sums;
}

struct BadMap {
  DisparityMap map;
  std::string rule;
};

/// sound_map() with each mistake that a map can have.
std::vector<BadMap> bad_maps(float disparity = 2) {
  std::vector<BadMap> all;
  const auto add = [&](const std::string& rule, const auto& spoil) {
    DisparityMap map = sound_map(disparity);
    spoil(map);
    all.push_back({map, rule});
  };
  const std::string size = "the map does not have the image's size";
  const std::string disagree = "disparity and status disagree on whether there is one";
  add(size, [](DisparityMap& map) { map = DisparityMap(); });
  add(size, [](DisparityMap& map) { map = DisparityMap({3, 3}); });
  add(size, [](DisparityMap& map) { map.status = map.status.rowRange(1, 7); });
  add(size, [](DisparityMap& map) { map.status.release(); });
  add(size, [](DisparityMap& map) { static_cast<cv::Mat&>(map.disparity) = cv::Mat1d(kSize, 2); });
  add(size, [](DisparityMap& map) { static_cast<cv::Mat&>(map.status) = cv::Mat3b(kSize); });
  add(disagree + " (x 5, y 3)", [](DisparityMap& map) { map.disparity(3, 5) = kNan; });
  add(disagree + " (x 5, y 3)", [](DisparityMap& map) { map.disparity(3, 5) = kInfinity; });
  add(disagree + " (x 5, y 3)", [](DisparityMap& map) { map.set(3, 5, -kInfinity); });
  add(disagree + " (x 0, y 0)", [](DisparityMap& map) { map.disparity(0, 0) = 1; });
  add("the status is none there is (x 11, y 6)",
      [](DisparityMap& map) { map.status(6, 11) = kStatusCount; });
  add("the confidence does not have the image's size",
      [](DisparityMap& map) { map.confidence = cv::Mat1f(3, 3, 1.0F); });
  add("a confidence is not in 0 to 1 (x 5, y 3)", [](DisparityMap& map) {
    map.confidence = cv::Mat1f(kSize, 1.0F);
    map.confidence(3, 5) = 1.001F;
  });
  return all;
}

/// A kind of another room.
struct Blur : Stage {
  static constexpr std::string_view kKind = "blur";
  virtual DisparityMap run(const DisparityMap& map, const Context&) const = 0;
};
using DoingBlur = Doing<Blur, DisparityMap, const DisparityMap&>;

template <class Stage, class Result, class... Inputs>
std::string told(const Result& result, const Inputs&... inputs) {
  return error_of([&] { slot_of<Stage>([&](auto&&...) { return result; })(Context(), inputs...); });
}

void check_told(const std::string& error, const std::string& kind, const std::string& rule) {
  CHECK(error == "here: " + kind + " 'bad' returned a faulty result: " + rule +
                     "; correct the plugin, or use another one");
}

std::string told_of_range(const DisparityRange& result) {
  return told<DoingSearchRange>(result, sound_map(), range());
}

}  // namespace

TEST_CASE("a map with a mistake in it is told of every kind of stage that returns maps") {
  for (const auto& [map, name] : bad_maps()) {
    const std::string& rule = name;  // clang 14 captures no bindings
    CAPTURE(rule);
    check_told(told<DoingFilter>(map, sound_map(), pair_of_images()), "filter", rule);
    check_told(told<DoingSelection>(map, sums()), "selection", rule);
    check_told(told<DoingRefinement>(map, sound_map(), sums()), "refinement", rule);
    check_told(told<DoingMatcher>(MatchResult{map, {}}, request()), "matcher", rule);
    const MatchResult sound{sound_map(), sound_map()};
    check_told(told<DoingConsistency>(MatchResult{map, sound_map()}, sound), "consistency", rule);
    check_told(told<DoingConsistency>(MatchResult{sound_map(), map}, sound), "consistency", rule);
  }
  for (const auto& [map, rule] : bad_maps(-2)) {
    check_told(told<DoingMatcher>(MatchResult{sound_map(), map}, request()), "matcher", rule);
  }
}

TEST_CASE("maps of kinds that the core does not know keep the rules of all maps") {
  CHECK(told<DoingBlur>(sound_map(), sound_map()) == "");
  CHECK(told<DoingBlur>(DisparityMap({3, 3}), sound_map()) == "");
  DisparityMap wrong = sound_map();
  wrong.disparity(2, 4) = kNan;
  check_told(told<DoingBlur>(wrong, sound_map()), "blur",
             "disparity and status disagree on whether there is one (x 4, y 2)");
}

TEST_CASE("sound results pass through slots as they are") {
  CHECK(told<DoingFilter>(sound_map(), sound_map(), pair_of_images()) == "");
  CHECK(told<DoingSelection>(sound_map(), sums()) == "");
  CHECK(told<DoingRefinement>(sound_map(2.5F), sound_map(), sums()) == "");
  CHECK(told<DoingMatcher>(MatchResult{sound_map(), sound_map(-2)}, request()) == "");
  CHECK(told<DoingPreprocess>(pair_of_images(), pair_of_images()) == "");
  CHECK(told_of_range(range()) == "");
}

TEST_CASE("confidences have the size of the map, and are in 0 to 1 or NaN") {
  const ImagePair pair = pair_of_images();
  const DisparityMap map = sound_map();
  const Evidence evidence{pair, map};
  const auto told_of = [&](const cv::Mat1f& result) {
    return told<DoingConfidence>(result, evidence);
  };
  cv::Mat1f sure(kSize, kNan);
  sure(0, 0) = 0;
  sure(6, 11) = 1;
  CHECK(told_of(sure) == "");
  check_told(told_of(cv::Mat1f()), "confidence", "the confidence does not have the image's size");
  check_told(told_of(sure.colRange(1, 5)), "confidence",
             "the confidence does not have the image's size");
  for (const float wrong : {-0.001F, 1.001F, kInfinity, -kInfinity}) {
    sure(3, 4) = wrong;
    check_told(told_of(sure), "confidence", "a confidence is not in 0 to 1 (x 4, y 3)");
  }
}

TEST_CASE("matchers leave neither the range nor the pixels that have data") {
  const std::string outside = "a disparity lies outside the range (x 1, y 0)";
  for (const float wrong : {-1.0F, 4.0F, 1000.0F, -1e30F}) {
    check_told(told<DoingMatcher>(MatchResult{sound_map(wrong), {}}, request()), "matcher",
               outside);
    check_told(told<DoingMatcher>(MatchResult{sound_map(), sound_map(-wrong)}, request()),
               "matcher", outside);
  }
  for (const float right : {-0.5F, 3.5F}) {
    CHECK(told<DoingMatcher>(MatchResult{sound_map(right), {}}, request()) == "");
  }
  MatchRequest masked = request();
  masked.pair.base.valid = cv::Mat1b(kSize, 255);
  masked.pair.base.valid(4, 9) = 0;
  check_told(told<DoingMatcher>(MatchResult{sound_map(), {}}, masked), "matcher",
             "a pixel without data has a disparity (x 9, y 4)");
  MatchRequest other = request();
  other.reverse_range = DisparityRange::uniform(kSize, {-9, -5});
  CHECK(told<DoingMatcher>(MatchResult{sound_map(), sound_map(-7)}, other) == "");
}

TEST_CASE("filters stay in the range that the run searches, but for what they fill") {
  const auto filtered = [](const Context& context, const DisparityMap& map) {
    return error_of([&] {
      slot_of<DoingFilter>([&](auto&&...) { return map; })(context, map, pair_of_images());
    });
  };
  Context context;
  context.take_view(request());
  CHECK(filtered(context, sound_map(3)) == "");
  CHECK(filtered(context, sound_map(5)) != "");
  CHECK(filtered(context.other_view(), sound_map(-3)) == "");
  CHECK(filtered(context.other_view(), sound_map(3)) != "");
  CHECK(filtered(context.level("s2", 2), sound_map(2)) == "");
  CHECK(filtered(context.level("s2", 2), sound_map(3)) != "");
  DisparityMap filled = sound_map(3);
  filled.set(2, 2, 5, Status::filled);
  CHECK(filtered(context, filled) == "");
  filled.set(2, 2, -12, Status::filled);  // as far as the image is wide: no pixel is there
  check_told(filtered(context, filled), "filter", "a disparity lies outside the range (x 2, y 2)");
}

TEST_CASE("selections choose whole disparities of the pixel's own range") {
  const std::string rule = "a disparity is not a whole one of the pixel's range (x 1, y 0)";
  for (const float wrong : {-1.0F, 0.5F, 4.0F, 1e9F}) {
    check_told(told<DoingSelection>(sound_map(wrong), sums()), "selection", rule);
  }
}

TEST_CASE("refinements move disparities by half a pixel, and leave statuses alone") {
  check_told(told<DoingRefinement>(sound_map(2.75F), sound_map(), sums()), "refinement",
             "a disparity was moved by more than half a pixel (x 1, y 0)");
  DisparityMap lost = sound_map();
  lost.invalidate(1, 1, Status::peak);
  check_told(told<DoingRefinement>(lost, sound_map(), sums()), "refinement",
             "a status was changed (x 1, y 1)");
}

TEST_CASE("consistency stages take away, and keep the map of either view") {
  const MatchResult maps{sound_map(), sound_map(-2)};
  const std::string rule = "a disparity was added or changed (x 0, y 0)";
  DisparityMap added = sound_map();
  added.set(0, 0, 2);
  check_told(told<DoingConsistency>(MatchResult{added, sound_map(-2)}, maps), "consistency", rule);
  check_told(told<DoingConsistency>(MatchResult{sound_map(), std::nullopt}, maps), "consistency",
             "the reverse map is gone");
}

TEST_CASE("preprocess stages keep size, planes, levels and views") {
  const auto spoiled = [](const auto& spoil) {
    ImagePair pair = pair_of_images();
    spoil(pair);
    return told<DoingPreprocess>(pair, pair_of_images());
  };
  const std::string kind = "preprocess";
  check_told(spoiled([](ImagePair& pair) { pair = {}; }), kind,
             "an image does not have one or three planes");
  check_told(spoiled([](ImagePair& pair) {
               pair.match = random_image({5, 5}, 1);
             }),
             kind, "planes or masks do not have the base image's size");
  check_told(spoiled([](ImagePair& pair) { pair.base.valid = cv::Mat1b(5, 5, uchar{255}); }), kind,
             "planes or masks do not have the base image's size");
  check_told(spoiled([](ImagePair& pair) {
               static_cast<cv::Mat&>(pair.base.planes[0]) = cv::Mat1b(kSize, 9);
             }),
             kind, "planes or masks do not have the base image's size");
  check_told(spoiled([](ImagePair& pair) { pair.match = random_image(kSize, 1, 3); }), kind,
             "one image is grey and the other in colour");
  check_told(spoiled([](ImagePair& pair) { pair.base.planes[0](2, 3) = kNan; }), kind,
             "a valid pixel has no finite level (x 3, y 2)");
  check_told(spoiled([](ImagePair& pair) { pair = pair.swapped(); }), kind,
             "base and match image were exchanged");
}

TEST_CASE("search ranges have the size of the limits, and something to search in each pixel") {
  check_told(told_of_range(DisparityRange::uniform({5, 5}, kRange)), "search_range",
             "the range does not have the size of the limits");
  cv::Mat1i begin(kSize, 0), end(kSize, 4);
  end(3, 8) = -2;
  check_told(told_of_range({begin, end}), "search_range",
             "an interval ends before it begins (x 8, y 3)");
  end(3, 8) = 0;
  check_told(told_of_range({begin, end}), "search_range",
             "a pixel has nothing to search (x 8, y 3)");
  check_told(told_of_range(DisparityRange::uniform(kSize, {4, 0})), "search_range",
             "a pixel has nothing to search (x 0, y 0)");
}

TEST_CASE("volumes have the shape that was asked for, and bounds that fit their cells") {
  const auto shape = std::make_shared<const VolumeShape>(range());
  const auto smaller = std::make_shared<const VolumeShape>(DisparityRange::uniform({3, 3}, kRange));
  const auto costs = [&](const VolumeShapePtr& given, int bound) {
    return error_of([&] {
      slot_of<DoingCost>([&](auto&&...) { return CostVolume(given, bound); })(
          Context(), pair_of_images(), shape);
    });
  };
  CHECK(costs(shape, 24) == "");
  check_told(costs(smaller, 24), "cost", "the volume does not have the shape given");
  check_told(costs(shape, 255), "cost", "max_cost is not in 0 to 254");
  check_told(costs(shape, -1), "cost", "max_cost is not in 0 to 254");
  check_told(error_of([&] {
               slot_of<DoingCost>([&](auto&&...) {
                 CostVolume made(shape, 24);
                 const CostVolume taken = std::move(made);
                 return made;
               })(Context(), pair_of_images(), shape);
             }),
             "cost", "the volume does not have the shape given");
  const auto aggregated = [&](const VolumeShapePtr& given, int bits) {
    struct NoPenalty final : PenaltyField {
      PenaltyTable table(Direction) const override { return {}; }
    };
    return error_of([&] {
      slot_of<DoingAggregation>([&](auto&&...) { return AggregatedVolume(given, bits); })(
          Context(), CostVolume(shape, 24), NoPenalty());
    });
  };
  CHECK(aggregated(shape, 2) == "");
  check_told(aggregated(smaller, 2), "aggregation", "the sums do not have the costs' shape");
  check_told(aggregated(shape, 16), "aggregation", "fraction_bits is not in 0 to 15");
}
