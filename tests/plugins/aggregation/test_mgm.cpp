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
  const auto stage = testing::stage<Aggregation>(
      "{type: mgm, directions: " + std::to_string(directions) +
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
    for (const aggregation::Pass& pass : mgm::passes(directions)) {
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
            CHECK(result.largest <= directions * steps * result.unit / 2);
          }
}

TEST_CASE("mgm is exact while no half has to be rounded") {
  // On two rows and columns paths have at most two steps; F >= 2 holds their halves of halves.
  const CostVolume costs = random_costs(dense_shape({2, 2}, {-1, 2}), 24, 3);
  for (const int directions : {4, 8, 16}) {
    const Comparison result = compare(costs, RandomPenalties(2, 2, 96, 3), directions);
    CHECK(result.unit <= 0.25);
    CHECK(result.largest == 0);
  }
}

TEST_CASE("mgm has the oracle's winner at 99.9 % of the pixels") {
  const cv::Size size(160, 120);
  const auto report = [](const char* name, int directions, const Comparison& result) {
    MESSAGE(name, ", ", directions, " directions: same winner ", 100 * result.agreement,
            " %, unit ", result.unit, ", error of S rms ", result.rms, ", largest ",
            result.largest);
    CHECK(result.agreement >= 0.999);
  };
  const ConstantPenalties usual(24, 96);
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
  }
}
