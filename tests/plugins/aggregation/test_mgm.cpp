// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include "inputs.hpp"
#include "oracle.hpp"
#include "plugins/aggregation/mgm/passes.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

AggregatedVolume run_mgm(const CostVolume& costs, const PenaltyField& penalties, int directions,
                         bool corrected = true) {
  const auto stage =
      testing::stage<Aggregation>("{type: mgm, directions: " + std::to_string(directions) +
                                  ", overcounting_correction: " + (corrected ? "true}" : "false}"));
  return stage->run(costs, penalties, Context{});
}

/// How S compares with the oracle, both less their minimum per pixel.
struct Comparison {
  double agreement = 0;  ///< share of pixels with the same winner
  double unit = 0;       ///< 2^-fraction_bits
  double rms = 0;        ///< error of S, in costs
  double largest = 0;
  bool same_holes = true;
};

Comparison compare(const CostVolume& costs, const PenaltyField& penalties, int directions,
                   bool corrected = true) {
  const VolumeShape& shape = costs.shape();
  Oracle oracle(costs, penalties, Oracle::Method::mgm);
  const Sums expected = less_minimum(shape, oracle.sums(directions, corrected));
  const AggregatedVolume result = run_mgm(costs, penalties, directions, corrected);
  const Sums found = less_minimum(shape, to_sums(result));
  Comparison comparison;
  comparison.unit = 1.0 / (1 << result.fraction_bits);
  std::int64_t cells = 0, pixels = 0, same = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::isinf(found[i]) != std::isinf(expected[i])) comparison.same_holes = false;
    if (std::isinf(found[i]) || std::isinf(expected[i])) continue;
    const double error = std::abs(found[i] - expected[i]);
    comparison.rms += error * error;
    comparison.largest = std::max(comparison.largest, error);
    ++cells;
  }
  comparison.rms = std::sqrt(comparison.rms / double(std::max<std::int64_t>(cells, 1)));
  for (int y = 0; y < shape.height(); ++y)
    for (int x = 0; x < shape.width(); ++x) {
      if (shape.count(y, x) == 0) continue;
      const auto begin = shape.offset(y, x), end = begin + shape.count(y, x);
      const auto a = std::min_element(found.begin() + begin, found.begin() + end);
      const auto b = std::min_element(expected.begin() + begin, expected.begin() + end);
      ++pixels;
      same += a - found.begin() == b - expected.begin();
    }
  comparison.agreement = double(same) / double(std::max<std::int64_t>(pixels, 1));
  return comparison;
}

/// Hamming distances of 24 bits: a slanted plane that matches well, half the bits elsewhere.
CostVolume census_like_costs(const VolumeShapePtr& shape, std::uint64_t seed) {
  Random random(seed);
  CostVolume costs(shape, 24);
  for (int y = 0; y < shape->height(); ++y)
    for (int x = 0; x < shape->width(); ++x)
      for (int i = 0; i < shape->count(y, x); ++i) {
        const int d = shape->begin(y, x) + i;
        const int odds = std::abs(d - (x / 16 + y / 8)) <= 1 ? 6 : 2;  // one bit in `odds` differs
        int c = 0;
        for (int bit = 0; bit < 24; ++bit) c += random.integer(1, odds) == 1;
        costs.at(y, x)[i] = x - d < 0 || x - d >= shape->width() ? CostVolume::kNoMatch
                                                                 : static_cast<std::uint8_t>(c);
      }
  return costs;
}

const cv::Size kSizes[] = {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 7}, {37, 23}};

}  // namespace

TEST_CASE("mgm's passes hold every direction once, and visit what they need before") {
  for (const int directions : {4, 8, 16}) {
    std::set<std::pair<int, int>> seen;
    std::vector<aggregation::Pass> all;
    for (const aggregation::Pass& pass : mgm::passes(directions))
      std::ranges::copy(aggregation::both_directions(pass), std::back_inserter(all));
    for (const aggregation::Pass& pass : all) {
      CHECK(pass.paths.size() == static_cast<std::size_t>(directions) / 4);
      for (const aggregation::Path& path : pass.paths) {
        REQUIRE(path.steps.size() == 2);
        const auto [r, perpendicular] = std::pair(path.steps[0], path.steps[1]);
        CHECK(perpendicular == Direction{r.dy, -r.dx});
        CHECK(aggregation::comes_earlier(r, pass.along, pass.across));
        CHECK(aggregation::comes_earlier(perpendicular, pass.along, pass.across));
        seen.emplace(r.dx, r.dy);
      }
    }
    std::set<std::pair<int, int>> expected;
    for (const Direction r : all_directions(directions)) expected.emplace(r.dx, r.dy);
    CHECK(seen == expected);
  }
}

TEST_CASE("mgm equals Eq. 6 within the derived bound of its fixed-point error") {
  std::uint64_t seed = 0;
  for (const cv::Size size : kSizes)
    for (const bool ragged : {false, true})
      for (const int directions : {4, 8, 16})
        for (const bool corrected : {false, true})
          for (const int classes : {1, 2, 3}) {
            ++seed;
            const Interval hull{-6, 21};
            const CostVolume costs = random_costs(
                ragged ? ragged_shape(size, hull, seed) : dense_shape(size, hull), 24, seed);
            const Comparison result = compare(
                costs, RandomPenalties(classes, 4 - classes, 96, seed), directions, corrected);
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(directions);
            CHECK(result.same_holes);
            const int steps = size.width + size.height;  // of the longest path
            CHECK(result.largest <= directions * steps * result.unit);
          }
}

TEST_CASE("mgm is exact while no half has to be rounded") {
  // On two rows and columns paths have at most two steps; two bits hold their halves of halves.
  const CostVolume costs = random_costs(dense_shape({2, 2}, {-1, 2}), 24, 3);
  for (const int directions : {4, 8, 16}) {
    const Comparison result = compare(costs, RandomPenalties(2, 2, 36, 3), directions);
    CHECK(result.unit <= 0.25);
    CHECK(result.largest == 0);
  }
}

TEST_CASE("mgm has the oracle's winner nearly everywhere, as far as its fraction bits go") {
  const cv::Size size(160, 120);
  const auto report = [](const std::string& name, int directions, const Comparison& result) {
    MESSAGE(name, ", ", directions, " directions: same winner ", 100 * result.agreement,
            " %, unit ", result.unit, ", error of S rms ", result.rms, ", largest ",
            result.largest);
    // Where costs are noise winners are near ties, and the rest differs by what one step differs.
    CHECK(result.agreement >= (result.unit > 0.25 ? 0.96 : 0.995));
    CHECK(result.rms <= std::sqrt(directions) * result.unit);  // the paths' errors are independent
  };
  const ConstantPenalties usual(24, 96), strong(60, 240);
  const RandomPenalties varying(2, 2, 96, 17);
  for (const int directions : {4, 8, 16}) {
    const CostVolume noise = random_costs(dense_shape(size, {0, 64}), 24, 1);
    report("noise, P 24/96", directions, compare(noise, usual, directions));
    report("noise, random P", directions, compare(noise, varying, directions));
    const CostVolume scene = census_like_costs(dense_shape(size, {0, 64}), 2);
    report("census-like, P 24/96", directions, compare(scene, usual, directions));
    report("census-like, uncorrected", directions, compare(scene, usual, directions, false));
    const CostVolume ragged = census_like_costs(ragged_shape(size, {-5, 60}, 4), 4);
    report("ragged, P 24/96", directions, compare(ragged, usual, directions));
    report("ragged, P 60/240", directions, compare(ragged, strong, directions));
  }
}

TEST_CASE("the overcounting correction of mgm is S - (N - 1) C") {
  const CostVolume costs = random_costs(ragged_shape({25, 18}, {-5, 25}, 2), 24, 2);
  const RandomPenalties penalties(2, 2, 96, 2);
  for (const int directions : {4, 8, 16}) {
    const AggregatedVolume plain = run_mgm(costs, penalties, directions, false);
    const AggregatedVolume corrected = run_mgm(costs, penalties, directions, true);
    REQUIRE(plain.fraction_bits == corrected.fraction_bits);
    bool all_hold = true;
    const auto c = all_cells(costs);
    const auto s = all_cells(plain), found = all_cells(corrected);
    for (std::size_t i = 0; i < c.size(); ++i) {
      const int surplus = (directions - 1) * c[i] * (1 << plain.fraction_bits);
      all_hold = all_hold && found[i] == (c[i] == CostVolume::kNoMatch ? s[i] : s[i] - surplus);
    }
    CHECK(all_hold);
  }
}

TEST_CASE("mgm on a ragged volume with equal ranges gives what the dense one gives") {
  const cv::Size size(27, 16);
  const auto ragged =
      std::make_shared<VolumeShape>(DisparityRange(cv::Mat1i(size, -4), cv::Mat1i(size, 19)));
  const RandomPenalties penalties(2, 2, 96, 1);
  CHECK(identical(run_mgm(random_costs(dense_shape(size, {-4, 19}), 24, 6), penalties, 16),
                  run_mgm(random_costs(ragged, 24, 6), penalties, 16)));
}

TEST_CASE("mgm does not depend on the number of threads") {
  const CostVolume costs = random_costs(ragged_shape({211, 137}, {-5, 25}, 8), 24, 8);
  const RandomPenalties penalties(2, 2, 96, 8);
  const xgm::ThreadLimit one(1);
  const AggregatedVolume expected = run_mgm(costs, penalties, 16);
  for (const int count : {2, 3, 8}) {
    const xgm::ThreadLimit threads(count);
    CHECK(identical(run_mgm(costs, penalties, 16), expected));
  }
}

TEST_CASE("a volume turned by a right angle gives mgm's sums turned") {
  const cv::Size size(26, 17);
  const auto shape = dense_shape(size, {0, 21});
  const auto turned_shape = dense_shape({size.height, size.width}, {0, 21});
  const CostVolume costs = random_costs(shape, 24, 12);
  const auto turn = [&](const auto& from, auto& to) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        std::copy_n(from.at(y, x), 21, to.at(size.width - 1 - x, y));
  };
  CostVolume turned(turned_shape, 24);
  turn(costs, turned);
  const ConstantPenalties penalties(7, 40);
  for (const int directions : {4, 8, 16}) {
    const AggregatedVolume sums = run_mgm(costs, penalties, directions);
    AggregatedVolume expected(turned_shape, sums.fraction_bits);
    turn(sums, expected);
    CHECK(identical(run_mgm(turned, penalties, directions), expected));
  }
}

TEST_CASE("mgm holds the largest costs and penalties that fit, and refuses larger ones") {
  const CostVolume costs = random_costs(ragged_shape({19, 13}, {0, 20}, 3), 254, 3);
  for (const int directions : {4, 8, 16}) {
    const int most = (65534 - 254) / directions;
    const Comparison result = compare(costs, ConstantPenalties(most, most), directions);
    CHECK(result.unit == 1);
    CHECK(result.same_holes);
    CHECK(result.largest <= directions * (19 + 13));
    CHECK_THROWS_AS(run_mgm(costs, ConstantPenalties(0, most + 1), directions), Error);
  }
}

TEST_CASE("mgm without costs and penalties, and without cells, gives zeros and nothing") {
  CostVolume costs(dense_shape({6, 5}, {0, 2}), 0);
  std::fill_n(costs.data(), costs.shape().cells(), std::uint8_t{0});
  const AggregatedVolume sums = run_mgm(costs, ConstantPenalties(0, 0), 8);
  CHECK(all_cells(sums) == std::vector<std::uint16_t>(60, 0));
  const CostVolume none(dense_shape({6, 5}, {0, 0}), 24);
  CHECK(run_mgm(none, ConstantPenalties(1, 2), 8).shape().cells() == 0);
}

TEST_CASE("an exception of the penalties ends a pass along columns, too") {
  struct Faulty final : PenaltyField {
    PenaltyTable table(Direction) const override { return {2, 1, {{1, 2}, {3, 4}}}; }
    void classify(Direction r, int, std::span<std::uint8_t> base,
                  std::span<std::uint8_t>) const override {
      std::ranges::fill(base, std::uint8_t{1});
      if (r == Direction{0, -1}) throw Error("upwards");
    }
  };
  const CostVolume costs = random_costs(dense_shape({20, 10}, {0, 16}), 24, 1);
  CHECK_THROWS_WITH(run_mgm(costs, Faulty(), 4), "upwards");
}
