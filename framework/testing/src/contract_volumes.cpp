// SPDX-License-Identifier: Apache-2.0
// Contracts of the stages that make volumes: cost and aggregation.
#include "contract_cells.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

bool can_match(const ImagePair& pair, int y, int x, int d) {
  const int x_match = x - d;
  return x_match >= 0 && x_match < pair.size().width && pair.match.is_valid(y, x_match);
}

void expect_costs(Report& report, const CostVolume& costs, const ImagePair& pair) {
  each_cell(costs.shape(), [&](int y, int x, int d, int i) {
    const std::uint8_t cost = costs.at(y, x)[i];
    const bool matchable = can_match(pair, y, x, d);
    report.expect(matchable || cost == CostVolume::kNoMatch,
                  "a cost where nothing can match is not kNoMatch", y, x);
    report.expect(!matchable || cost <= costs.max_cost,
                  "a cost exceeds max_cost, or is kNoMatch where there is a match", y, x);
  });
}

/// Costs that look like a cost stage's, but depend on nothing but the cell: kNoMatch for one in
/// eight and outside of `inside`.
CostVolume random_costs(const VolumeShapePtr& shape, int max_cost, const VolumeShape& inside) {
  CostVolume costs(shape, max_cost);
  each_cell(*shape, [&](int y, int x, int d, int i) {
    const bool there = inside.begin(y, x) <= d && d < inside.end(y, x);
    const bool match = there && chance(3, y, x, d) > 0.125;
    costs.at(y, x)[i] = match ? static_cast<std::uint8_t>(chance(4, y, x, d) * (max_cost + 1))
                              : CostVolume::kNoMatch;
  });
  return costs;
}

/// Two classes on either side, other penalties for other directions.
class PatternPenalties final : public PenaltyField {
 public:
  explicit PatternPenalties(int scale) : scale_(scale) {}

  PenaltyTable table(Direction r) const override {
    const int p1 = scale_ * (2 + (r.dx & 1)), p2 = scale_ * (7 + (r.dy & 1));
    return {2, 2, {{p1, p2}, {p1, p1}, {0, p2}, {p1 / 2, p2 / 2}}};
  }
  void classify(Direction r, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    for (std::size_t i = 0; i < base.size(); ++i) {
      const int x = static_cast<int>(i);
      base[i] = chance(5, y, x, r.dx) < 0.5 ? 0 : 1;
      match[i] = chance(6, y, x, r.dy) < 0.5 ? 0 : 1;
    }
  }

 private:
  int scale_;
};

void expect_sums(Report& report, const AggregatedVolume& sums, const CostVolume& costs) {
  if (sums.shape_ptr() != costs.shape_ptr()) return;
  each_cell(sums.shape(), [&](int y, int x, int, int i) {
    const bool no_cost = costs.at(y, x)[i] == CostVolume::kNoMatch;
    const bool no_sum = sums.at(y, x)[i] == AggregatedVolume::kNoMatch;
    report.expect(no_cost == no_sum, "a sum is kNoMatch where its cost is not, or the reverse", y,
                  x);
  });
}

/// The cells of `ragged` against the same cells of `dense`, whose other cells are kNoMatch.
void expect_same_sums(Report& report, const AggregatedVolume& ragged,
                      const AggregatedVolume& dense) {
  each_cell(ragged.shape(), [&](int y, int x, int d, int i) {
    const int first = ragged.at(y, x)[i] - smallest(ragged, y, x);
    const int second = dense.at(y, x)[d - dense.shape().begin(y, x)] - smallest(dense, y, x);
    const bool no_match = ragged.at(y, x)[i] == AggregatedVolume::kNoMatch;
    report.expect(no_match || first == second,
                  "missing cells and kNoMatch cells do not mean the same", y, x);
  });
}

void check_aggregation_on(Report& report, const Aggregation& stage, const Input& input,
                          int max_cost) {
  const VolumeShapePtr dense =
      shape_of(DisparityRange::uniform(input.range.size(), input.range.hull()), {});
  const VolumeShapePtr ragged = shape_of(input.range, input.pair.base.valid);
  const PatternPenalties penalties(max_cost > 100 ? 100 : 5);
  const bool accepts_ragged = stage.accepts_ragged_volumes();
  const VolumeShapePtr& shape = accepts_ragged ? ragged : dense;
  const CostVolume costs = random_costs(shape, max_cost, *ragged);
  const Bytes before = bytes_of(costs);
  const AggregatedVolume sums =
      run_with_threads(report, [&] { return stage.run(costs, penalties, Context{}); });
  report.expect(bytes_of(costs) == before, "the costs were changed");
  report.expect_none(Aggregation::fault_of(sums, costs, penalties, Context{}));
  expect_sums(report, sums, costs);
  if (accepts_ragged && sums.shape_ptr() == costs.shape_ptr())
    expect_same_sums(report, sums,
                     stage.run(random_costs(dense, max_cost, *ragged), penalties, Context{}));
}

}  // namespace

Violations check_cost(const Cost& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    report.with(input.name, [&] {
      const ImagePair& pair = input.pair;
      const Bytes before = bytes_of(pair);
      const VolumeShapePtr shape = shape_of(input.range, pair.base.valid);
      const CostVolume costs =
          run_with_threads(report, [&] { return stage.run(pair, shape, Context{}); });
      report.expect(bytes_of(pair) == before, "the images were changed");
      report.expect_none(Cost::fault_of(costs, pair, shape, Context{}));
      if (costs.shape_ptr() != shape) return;
      expect_costs(report, costs, pair);
      for (const float level : {0.0F, 255.0F})
        report.expect(bytes_of(stage.run(with_levels_under_masks(pair, level), shape, Context{})) ==
                          bytes_of(costs),
                      "grey levels of masked pixels matter: leave those out of windows, "
                      "too, for which is_valid() is false");
      const VolumeShapePtr hull =
          shape_of(DisparityRange::uniform(pair.size(), input.range.hull()), pair.base.valid);
      const CostVolume dense = stage.run(pair, hull, Context{});
      each_cell(*shape, [&](int y, int x, int d, int i) {
        report.expect(costs.at(y, x)[i] == dense.at(y, x)[d - hull->begin(y, x)],
                      "a cost depends on which other cells there are", y, x);
      });
    });
  }
  return report.take();
}

Violations check_aggregation(const Aggregation& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs())
    for (const int max_cost : {24, 254})
      report.with(input.name + ", costs up to " + std::to_string(max_cost),
                  [&] { check_aggregation_on(report, stage, input, max_cost); });
  return report.take();
}

}  // namespace xgm::testing
