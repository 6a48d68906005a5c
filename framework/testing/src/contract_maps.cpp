// SPDX-License-Identifier: Apache-2.0
// Contracts of the stages that work on disparity maps: filter, fuser, consistency, search_range.
#include <cmath>
#include <limits>

#include "contract_support.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

bool is_masked(const DisparityMap& map, int y, int x) { return map.at(y, x) == Status::masked; }

/// A map as matching leaves it: surfaces, false matches, and missing pixels of every kind.
DisparityMap rough_map(const Image& view, Interval range, std::uint64_t key) {
  DisparityMap map(view.size());
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      const double surface = chance(key, y / 11, x / 13), wrong = chance(key + 1, y, x);
      const double share = wrong < 0.1 ? wrong * 10 : 0.2 + 0.6 * surface;
      const double d = range.begin + share * std::max(0, range.size() - 1);
      const double kind = chance(key + 2, y / 2, x / 3);
      const auto status = static_cast<Status>(static_cast<int>(kind * 3 * kStatusCount));
      if (!view.is_valid(y, x))
        map.invalidate(y, x, Status::masked);
      else if (kind * 3 >= 1 || has_disparity(status) || status == Status::masked)
        map.set(y, x, static_cast<float>(d));
      else
        map.invalidate(y, x, status);
    }
  }
  return map;
}

/// One disparity everywhere, but for a few single pixels.
DisparityMap flat_map(cv::Size size, float d, Status hole, double holes) {
  DisparityMap map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      map.set(y, x, d);
      if (chance(20, y, x) < holes) map.invalidate(y, x, hole);
    }
  }
  return map;
}

template <class Body>
void each_pixel(cv::Size size, const Body& body) {
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) body(y, x);
}

void check_filter_on(Report& report, const Filter& stage, const ImagePair& pair, DisparityMap map) {
  if (stage.needs_confidence()) map.confidence = some_confidence(map);
  const Bytes pair_before = bytes_of(pair), map_before = bytes_of(map);
  const DisparityMap result =
      run_with_threads(report, [&] { return stage.run(map, pair, Context{}); });
  report.expect(bytes_of(pair) == pair_before && bytes_of(map) == map_before,
                "the inputs were changed");
  report.expect_none(Filter::fault_of(result, map, pair, Context{}));
  if (result.size() != map.size()) return;
  each_pixel(map.size(), [&](int y, int x) {
    report.expect(is_masked(result, y, x) == is_masked(map, y, x),
                  "other pixels are masked than before", y, x);
  });
  for (const float level : {0.0F, 255.0F}) {
    const ImagePair other = with_levels_under_masks(pair, level);
    report.expect(bytes_of(stage.run(map, other, Context{})) == bytes_of(result),
                  "grey levels of masked pixels matter");
  }
}

void check_holes(Report& report, const Filter& stage) {
  const Input input = inputs().front();
  report.with("flat map with single missing pixels", [&] {
    DisparityMap map = flat_map(input.pair.size(), 5.25F, Status::mismatched, 0.03);
    DisparityMap whole = flat_map(input.pair.size(), 5.25F, Status::mismatched, 0);
    if (stage.needs_confidence()) {
      map.confidence = some_confidence(map);
      whole.confidence = some_confidence(whole);
    }
    const DisparityMap result = stage.run(map, input.pair, Context{});
    // A filter may well take pixels away by design, at the border for example.
    const DisparityMap expected = stage.run(whole, input.pair, Context{});
    report.expect_none(Filter::fault_of(result, map, input.pair, Context{}));
    if (result.size() != map.size() || expected.size() != map.size()) return;
    each_pixel(map.size(), [&](int y, int x) {
      report.expect(
          result.has_disparity(y, x) || !map.has_disparity(y, x) || !expected.has_disparity(y, x),
          "a missing pixel takes another with it", y, x);
    });
  });
}

/// As of matchers that know how sure they are; the first ones also matched the other view.
Candidates rough_candidates(const ImagePair& pair, Interval range, int count) {
  Candidates candidates;
  for (int i = 0; i < count; ++i) {
    const auto key = static_cast<std::uint64_t>(100 + 10 * i);
    DisparityMap& map = candidates.maps.emplace_back(rough_map(pair.base, range, key));
    map.confidence.create(map.size());
    each_pixel(map.size(), [&](int y, int x) {
      map.confidence(y, x) = map.has_disparity(y, x) ? static_cast<float>(chance(key + 5, y, x))
                                                     : std::numeric_limits<float>::quiet_NaN();
    });
    const Interval reverse{1 - range.end, 1 - range.begin};
    candidates.others.push_back(2 * i < count ? rough_map(pair.match, reverse, key + 6)
                                              : DisparityMap());
  }
  return candidates;
}

Bytes bytes_of_all(const Candidates& candidates) {
  Bytes bytes;
  for (const auto* maps : {&candidates.maps, &candidates.others}) {
    for (const DisparityMap& map : *maps) bytes += map.disparity.empty() ? Bytes() : bytes_of(map);
  }
  return bytes;
}

void check_fuser_on(Report& report, const Fuser& stage, const ImagePair& pair, Interval range) {
  const int count = stage.matchers() == 0 ? 3 : stage.matchers();
  const Candidates candidates = rough_candidates(pair, range, count);
  const Bytes before = bytes_of_all(candidates);
  const DisparityMap result =
      run_with_threads(report, [&] { return stage.run(candidates, pair, Context{}); });
  report.expect(bytes_of_all(candidates) == before, "the inputs were changed");
  const auto fault = Fuser::fault_of(result, candidates, pair, Context{});
  report.expect_none(fault);
  if (fault) return;
  each_pixel(result.size(), [&](int y, int x) {
    report.expect(is_masked(result, y, x) == is_masked(candidates.maps.front(), y, x),
                  "other pixels are masked than before", y, x);
  });
  for (const float level : {0.0F, 255.0F}) {
    const ImagePair other = with_levels_under_masks(pair, level);
    report.expect(bytes_of(stage.run(candidates, other, Context{})) == bytes_of(result),
                  "grey levels of masked pixels matter");
  }
}

/// Maps that are all the same leave nothing to choose.
void check_agreeing(Report& report, const Fuser& stage) {
  const Input input = inputs().front();
  report.with("maps that are the same", [&] {
    Candidates candidates = rough_candidates(input.pair, input.range.hull(), 1);
    const DisparityMap map = candidates.maps.front();
    const int count = stage.matchers() == 0 ? 3 : stage.matchers();
    candidates.maps.resize(static_cast<std::size_t>(count), map);
    candidates.others.resize(static_cast<std::size_t>(count));
    DisparityMap result = stage.run(candidates, input.pair, Context{});
    result.confidence = map.confidence;
    report.expect(bytes_of(result) == bytes_of(map), "the result is another one");
  });
}

/// What was taken away has a reason that this kind may give, and nothing else has another one.
void expect_reasons(Report& report, const DisparityMap& checked, const DisparityMap& map) {
  each_pixel(map.size(), [&](int y, int x) {
    if (!map.has_disparity(y, x)) {
      report.expect(is_masked(checked, y, x) == is_masked(map, y, x),
                    "other pixels are masked than before", y, x);
    } else if (!checked.has_disparity(y, x)) {
      report.expect(checked.at(y, x) == Status::occluded || checked.at(y, x) == Status::mismatched,
                    "a pixel was taken away as something else than occluded or mismatched", y, x);
    }
  });
}

void check_consistency_on(Report& report, const Consistency& stage, const MatchResult& maps) {
  const Bytes before = bytes_of(maps);
  const MatchResult checked = run_with_threads(report, [&] { return stage.run(maps, Context{}); });
  report.expect(bytes_of(maps) == before, "the inputs were changed");
  const auto fault = Consistency::fault_of(checked, maps, Context{});
  report.expect_none(fault);
  if (fault) return;
  expect_reasons(report, checked.forward, maps.forward);
  expect_reasons(report, *checked.reverse, *maps.reverse);
}

void check_agreeing(Report& report, const Consistency& stage) {
  const cv::Size size(40, 23);
  report.with("maps that agree", [&] {
    const MatchResult maps{flat_map(size, 6, Status::peak, 0), flat_map(size, -6, Status::peak, 0)};
    const MatchResult checked = stage.run(maps, Context{});
    const auto fault = Consistency::fault_of(checked, maps, Context{});
    report.expect_none(fault);
    if (fault) return;
    each_pixel(size, [&](int y, int x) {
      const bool visible = x >= 6, visible_reverse = x + 6 < size.width;
      report.expect(!visible || checked.forward.has_disparity(y, x),
                    "an agreeing pixel was taken away", y, x);
      report.expect(!visible_reverse || checked.reverse->has_disparity(y, x),
                    "an agreeing pixel of the reverse map was taken away", y, x);
    });
  });
}

void check_search_range_on(Report& report, const SearchRange& stage, const DisparityMap& coarse,
                           const DisparityRange& limits) {
  const Bytes before = bytes_of(coarse), limits_before = bytes_of(limits);
  const DisparityRange range =
      run_with_threads(report, [&] { return stage.run(coarse, limits, Context{}); });
  report.expect(bytes_of(coarse) == before && bytes_of(limits) == limits_before,
                "the inputs were changed");
  report.expect_none(SearchRange::fault_of(range, coarse, limits, Context{}));
  if (range.size() != limits.size() || !limits.is_uniform()) return;
  each_pixel(limits.size(), [&](int y, int x) {
    report.expect(!intersect(range.at(y, x), limits.at(y, x)).empty(),
                  "a pixel has nothing to search", y, x);
  });
}

cv::Size half(cv::Size size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

void check_flat(Report& report, const SearchRange& stage) {
  const cv::Size fine(37, 24);
  report.with("flat coarse map", [&] {
    const DisparityMap coarse = flat_map(half(fine), 9, Status::occluded, 0.05);
    const DisparityRange limits = DisparityRange::uniform(fine, {0, 64});
    const DisparityRange range = stage.run(coarse, limits, Context{});
    const auto fault = SearchRange::fault_of(range, coarse, limits, Context{});
    report.expect_none(fault);
    if (fault) return;
    each_pixel(fine, [&](int y, int x) {
      report.expect(range.at(y, x).contains(18),
                    "the range does not hold twice the coarse disparity", y, x);
    });
  });
}

}  // namespace

Violations check_filter(const Filter& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    const Interval hull = input.range.hull();
    const ImagePair& pair = input.pair;
    report.with(input.name,
                [&] { check_filter_on(report, stage, pair, rough_map(pair.base, hull, 30)); });
    report.with(input.name + ", reverse map", [&] {
      const Interval reverse{1 - hull.end, 1 - hull.begin};
      check_filter_on(report, stage, pair.swapped(), rough_map(pair.match, reverse, 40));
    });
    report.with(input.name + ", map without disparities", [&] {
      DisparityMap map(pair.size(), Status::mismatched);
      each_pixel(map.size(), [&](int y, int x) {
        if (!pair.base.is_valid(y, x)) map.invalidate(y, x, Status::masked);
      });
      check_filter_on(report, stage, pair, map);
    });
  }
  check_holes(report, stage);
  return report.take();
}

Violations check_fuser(const Fuser& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    const Interval hull = input.range.hull();
    report.with(input.name, [&] { check_fuser_on(report, stage, input.pair, hull); });
    report.with(input.name + ", reverse maps", [&] {
      check_fuser_on(report, stage, input.pair.swapped(), {1 - hull.end, 1 - hull.begin});
    });
  }
  check_agreeing(report, stage);
  return report.take();
}

Violations check_consistency(const Consistency& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    const Interval hull = input.range.hull();
    report.with(input.name, [&] {
      check_consistency_on(report, stage,
                           {rough_map(input.pair.base, hull, 50),
                            rough_map(input.pair.match, {1 - hull.end, 1 - hull.begin}, 60)});
    });
  }
  check_agreeing(report, stage);
  return report.take();
}

Violations check_search_range(const SearchRange& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    const Image coarse(cv::Mat1f(half(input.pair.size()), 0.0F));
    const Interval hull = input.range.hull();
    const Interval coarse_hull{static_cast<int>(std::floor(hull.begin / 2.0)),
                               static_cast<int>(std::ceil(hull.end / 2.0))};
    report.with(input.name, [&] {
      check_search_range_on(report, stage, rough_map(coarse, coarse_hull, 70), input.range);
    });
    report.with(input.name + ", coarse map without disparities", [&] {
      check_search_range_on(report, stage, DisparityMap(coarse.size(), Status::occluded),
                            input.range);
    });
  }
  check_flat(report, stage);
  return report.take();
}

}  // namespace xgm::testing
