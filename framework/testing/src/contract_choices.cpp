// SPDX-License-Identifier: Apache-2.0
// Contracts of the stages that read sums: selection, refinement and confidence.
#include <cmath>

#include "contract_cells.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

/// Sums as of an aggregation, one in eight kNoMatch, and pixels without any match.
AggregatedVolume random_sums(const Input& input, int fraction_bits) {
  AggregatedVolume sums(shape_of(input.range, input.pair.base.valid), fraction_bits);
  each_cell(sums.shape(), [&](int y, int x, int d, int i) {
    const bool match = chance(7, y, x) > 0.1 && chance(8, y, x, d) > 0.125;
    sums.at(y, x)[i] =
        match ? static_cast<std::uint16_t>(chance(9, y, x, d) * 900) : AggregatedVolume::kNoMatch;
  });
  return sums;
}

void expect_selected(Report& report, const DisparityMap& map, const AggregatedVolume& sums) {
  const VolumeShape& shape = sums.shape();
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      const bool matchable = smallest(sums, y, x) != AggregatedVolume::kNoMatch;
      report.expect((map.at(y, x) == Status::out_of_range) != matchable,
                    "out_of_range is not where no cell can match", y, x);
      if (!map.has_disparity(y, x)) continue;
      const int chosen = static_cast<int>(map.disparity(y, x)) - shape.begin(y, x);
      report.expect(sums.at(y, x)[chosen] != AggregatedVolume::kNoMatch,
                    "a disparity was chosen that cannot match", y, x);
    }
  }
}

/// The first smallest sum of every pixel; every fifth pixel has been found ambiguous.
DisparityMap first_winners(const AggregatedVolume& sums) {
  DisparityMap map(sums.shape().size());
  each_cell(sums.shape(), [&](int y, int x, int d, int i) {
    const int sum = sums.at(y, x)[i];
    if (sum != AggregatedVolume::kNoMatch && sum == smallest(sums, y, x) &&
        !map.has_disparity(y, x))
      map.set(y, x, static_cast<float>(d));
  });
  for (int y = 0; y < map.size().height; ++y)
    for (int x = y % 5; x < map.size().width; x += 5)
      if (map.has_disparity(y, x)) map.invalidate(y, x, Status::ambiguous);
  return map;
}

/// Judges a map as its matcher would, which lacks what the stage does not ask for.
void check_confidence_on(Report& report, const Confidence& stage, const Input& input) {
  const AggregatedVolume sums = random_sums(input, 2);
  DisparityMap map = first_winners(sums);
  if (stage.needs_confidence()) map.confidence = some_confidence(map);
  const DisparityMap other =
      first_winners(random_sums({input.name, input.pair.swapped(), input.range.reversed()}, 2));
  const auto evidence = [&](const ImagePair& pair) {
    return Evidence{pair, map, stage.needs_sums() ? &sums : nullptr,
                    stage.needs_other_view() ? &other : nullptr};
  };
  const Bytes before = bytes_of(map) + bytes_of(sums) + bytes_of(other) + bytes_of(input.pair);
  const cv::Mat1f confidence =
      run_with_threads(report, [&] { return stage.run(evidence(input.pair), Context{}); });
  report.expect(bytes_of(map) + bytes_of(sums) + bytes_of(other) + bytes_of(input.pair) == before,
                "the evidence was changed");
  const auto fault = Confidence::fault_of(confidence, evidence(input.pair), Context{});
  report.expect_none(fault);
  if (fault) return;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      report.expect(map.has_disparity(y, x) || std::isnan(confidence(y, x)),
                    "a pixel without a disparity has a confidence", y, x);
    }
  }
  for (const float level : {0.0F, 255.0F}) {
    const ImagePair pair = with_levels_under_masks(input.pair, level);
    report.expect(bytes_of(stage.run(evidence(pair), Context{})) == bytes_of(confidence),
                  "grey levels of masked pixels matter");
  }
}

}  // namespace

Violations check_selection(const Selection& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    report.with(input.name, [&] {
      const AggregatedVolume sums = random_sums(input, 0);
      const Bytes before = bytes_of(sums);
      const DisparityMap map = run_with_threads(report, [&] { return stage.run(sums, Context{}); });
      report.expect(bytes_of(sums) == before, "the sums were changed");
      const auto fault = Selection::fault_of(map, sums, Context{});
      report.expect_none(fault);
      if (!fault) expect_selected(report, map, sums);
    });
  }
  return report.take();
}

Violations check_refinement(const Refinement& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    report.with(input.name, [&] {
      const AggregatedVolume sums = random_sums(input, 3);
      const DisparityMap map = first_winners(sums);
      const Bytes before = bytes_of(sums), map_before = bytes_of(map);
      const DisparityMap refined =
          run_with_threads(report, [&] { return stage.run(map, sums, Context{}); });
      report.expect(bytes_of(sums) == before && bytes_of(map) == map_before,
                    "the inputs were changed");
      report.expect_none(Refinement::fault_of(refined, map, sums, Context{}));
    });
  }
  return report.take();
}

Violations check_confidence(const Confidence& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    report.with(input.name, [&] { check_confidence_on(report, stage, input); });
  }
  return report.take();
}

}  // namespace xgm::testing
