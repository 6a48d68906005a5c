// SPDX-License-Identifier: Apache-2.0
#include "inputs.hpp"
#include "oracle.hpp"
#include "plugins/aggregation/path_engine/aggregate.hpp"
#include "plugins/aggregation/sgm/passes.hpp"

using namespace xgm;
using namespace xgm::testing;
using aggregation::PathCostWidth;

namespace {

AggregatedVolume run_sgm(const CostVolume& costs, const PenaltyField& penalties, int directions,
                         bool corrected = true) {
  const auto stage =
      testing::stage<Aggregation>("{type: sgm, directions: " + std::to_string(directions) +
                                  ", overcounting_correction: " + (corrected ? "true}" : "false}"));
  return stage->run(costs, penalties, Context{});
}

AggregatedVolume run_sgm(const CostVolume& costs, const PenaltyField& penalties, int directions,
                         bool corrected, PathCostWidth width) {
  return aggregation::aggregate_paths(costs, penalties, sgm::passes(directions),
                                      {.overcounting_correction = corrected, .width = width},
                                      Context{});
}

void check_equals_oracle(const CostVolume& costs, const PenaltyField& penalties) {
  Oracle oracle(costs, penalties, Oracle::Method::sgm);
  for (const int directions : {4, 8, 16})
    for (const bool corrected : {false, true}) {
      CAPTURE(directions);
      CAPTURE(corrected);
      const AggregatedVolume result = run_sgm(costs, penalties, directions, corrected);
      CHECK(result.fraction_bits == 0);
      CHECK(less_minimum(costs.shape(), to_sums(result)) ==
            less_minimum(costs.shape(), oracle.sums(directions, corrected)));
    }
}

const cv::Size kSizes[] = {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 7}, {37, 23}};

}  // namespace

TEST_CASE("sgm equals Eq. 3 and 4 exactly on dense volumes") {
  std::uint64_t seed = 0;
  for (const cv::Size size : kSizes)
    for (const Interval interval : {Interval{0, 1}, {-3, 5}, {0, 37}, {-40, 41}, {100, 103}}) {
      CAPTURE(size.width);
      CAPTURE(size.height);
      CAPTURE(interval.begin);
      const CostVolume costs = random_costs(dense_shape(size, interval), 24, ++seed);
      check_equals_oracle(costs, ConstantPenalties(5, 30));
      check_equals_oracle(costs, RandomPenalties(2, 2, 60, seed));
    }
}

TEST_CASE("sgm equals Eq. 3 and 4 exactly on ragged volumes") {
  std::uint64_t seed = 100;
  for (const cv::Size size : kSizes)
    for (const Interval hull : {Interval{0, 6}, {-20, 21}, {-3, 35}}) {
      CAPTURE(size.width);
      CAPTURE(size.height);
      CAPTURE(hull.begin);
      ++seed;
      const CostVolume costs = random_costs(ragged_shape(size, hull, seed), 24, seed);
      check_equals_oracle(costs, ConstantPenalties(5, 30));
      check_equals_oracle(costs, RandomPenalties(3, 2, 60, seed));
    }
}

TEST_CASE("sgm takes penalties from base classes, match classes and both") {
  const CostVolume costs = random_costs(ragged_shape({31, 19}, {-8, 20}, 7), 60, 7);
  for (const int base_classes : {1, 2, 5})
    for (const int match_classes : {1, 2, 5})
      for (const int p2_max : {0, 50, 500}) {
        CAPTURE(base_classes);
        CAPTURE(match_classes);
        check_equals_oracle(costs, RandomPenalties(base_classes, match_classes, p2_max, 3));
      }
}

TEST_CASE("sgm gives the same sums with 8-bit and 16-bit path costs") {
  for (const int p2 : {0, 1, 40, 230})  // 24 + P2 < 255 at the last
    for (const bool corrected : {false, true}) {
      const CostVolume costs = random_costs(ragged_shape({29, 17}, {-9, 30}, 5), 24, 5);
      const RandomPenalties penalties(2, 3, p2, 11);
      CHECK(identical(run_sgm(costs, penalties, 16, corrected, PathCostWidth::bits8),
                      run_sgm(costs, penalties, 16, corrected, PathCostWidth::bits16)));
    }
}

TEST_CASE("sgm uses the whole of 8-bit path costs, and 16 bit one step further") {
  const CostVolume costs = random_costs(dense_shape({23, 15}, {0, 20}), 254 - 70, 9);
  const ConstantPenalties fits(70, 70), does_not_fit(70, 71);
  CHECK(identical(run_sgm(costs, fits, 8, true, PathCostWidth::bits8),
                  run_sgm(costs, fits, 8, true, PathCostWidth::bits16)));
  CHECK_THROWS_AS(run_sgm(costs, does_not_fit, 8, true, PathCostWidth::bits8), Error);
  check_equals_oracle(costs, fits);
  check_equals_oracle(costs, does_not_fit);
}

TEST_CASE("sgm holds the largest costs and penalties that fit, and refuses larger ones") {
  const CostVolume costs = random_costs(ragged_shape({19, 13}, {0, 20}, 3), 254, 3);
  const int most = (65534 - 254) / 16;
  const ConstantPenalties largest(most, most);
  Oracle oracle(costs, largest, Oracle::Method::sgm);
  CHECK(less_minimum(costs.shape(), to_sums(run_sgm(costs, largest, 16))) ==
        less_minimum(costs.shape(), oracle.sums(16, true)));
  const std::string remedy = "lower P2 to at most " + std::to_string(most);
  CHECK_THROWS_WITH_AS(run_sgm(costs, ConstantPenalties(0, most + 1), 16),
                       doctest::Contains(remedy.c_str()), Error);
  CHECK_THROWS_AS(run_sgm(costs, ConstantPenalties(0, most), 16, false), Error);
  CHECK_NOTHROW(run_sgm(costs, ConstantPenalties(0, most + 1), 8));
}

TEST_CASE("sgm refuses penalties that are negative or whose P2 is below P1") {
  const CostVolume costs = random_costs(dense_shape({5, 4}, {0, 3}), 24, 1);
  CHECK_THROWS_AS(run_sgm(costs, ConstantPenalties(-1, 5), 8), Error);
  CHECK_THROWS_AS(run_sgm(costs, ConstantPenalties(6, 5), 8), Error);
}

TEST_CASE("the overcounting correction is S - (N - 1) C") {
  const CostVolume costs = random_costs(ragged_shape({25, 18}, {-5, 25}, 2), 24, 2);
  const RandomPenalties penalties(2, 2, 96, 2);
  for (const int directions : {4, 8, 16}) {
    const AggregatedVolume plain = run_sgm(costs, penalties, directions, false);
    const AggregatedVolume corrected = run_sgm(costs, penalties, directions, true);
    bool all_hold = true;
    const auto c = all_cells(costs);
    const auto s = all_cells(plain), found = all_cells(corrected);
    for (std::size_t i = 0; i < c.size(); ++i) {
      const int expected = c[i] == CostVolume::kNoMatch ? s[i] : s[i] - (directions - 1) * c[i];
      all_hold = all_hold && found[i] == expected;
    }
    CHECK(all_hold);
  }
}

TEST_CASE("sgm gives kNoMatch exactly where the cost is kNoMatch") {
  const CostVolume costs = random_costs(ragged_shape({25, 18}, {-5, 25}, 4), 254, 4);
  const AggregatedVolume sums = run_sgm(costs, ConstantPenalties(100, 3000), 16);
  bool all_hold = true;
  const auto c = all_cells(costs);
  const auto s = all_cells(sums);
  for (std::size_t i = 0; i < c.size(); ++i)
    all_hold = all_hold && (c[i] == CostVolume::kNoMatch) == (s[i] == AggregatedVolume::kNoMatch);
  CHECK(all_hold);
}

TEST_CASE("a ragged volume with equal ranges gives what the dense one gives") {
  const cv::Size size(27, 16);
  const auto ragged =
      std::make_shared<VolumeShape>(DisparityRange(cv::Mat1i(size, -4), cv::Mat1i(size, 19)));
  const CostVolume a = random_costs(dense_shape(size, {-4, 19}), 24, 6);
  const CostVolume b = random_costs(ragged, 24, 6);
  REQUIRE(identical(a, b));
  CHECK(identical(run_sgm(a, RandomPenalties(2, 2, 96, 1), 16),
                  run_sgm(b, RandomPenalties(2, 2, 96, 1), 16)));
}

TEST_CASE("sgm does not depend on the number of threads") {
  const CostVolume costs = random_costs(ragged_shape({211, 37}, {-5, 25}, 8), 24, 8);
  const RandomPenalties penalties(2, 2, 96, 8);
  const xgm::ThreadLimit one(1);
  const AggregatedVolume expected = run_sgm(costs, penalties, 16);
  for (const int count : {2, 3, 8}) {
    const xgm::ThreadLimit threads(count);
    CHECK(identical(run_sgm(costs, penalties, 16), expected));
  }
}

TEST_CASE("a mirrored volume gives mirrored sums") {
  const cv::Size size(26, 17);
  const auto shape = dense_shape(size, {0, 21});
  CostVolume costs = random_costs(shape, 24, 12), mirrored(shape, 24), flipped(shape, 24);
  const auto copy = [&](const auto& from, int y, int x, auto& to, int to_y, int to_x) {
    std::copy_n(from.at(y, x), shape->count(y, x), to.at(to_y, to_x));
  };
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      copy(costs, y, x, mirrored, y, size.width - 1 - x);
      copy(costs, y, x, flipped, size.height - 1 - y, x);
    }
  const ConstantPenalties penalties(7, 40);
  for (const int directions : {4, 8, 16}) {
    const AggregatedVolume sums = run_sgm(costs, penalties, directions);
    AggregatedVolume sums_mirrored(shape, 0), sums_flipped(shape, 0);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        copy(sums, y, x, sums_mirrored, y, size.width - 1 - x);
        copy(sums, y, x, sums_flipped, size.height - 1 - y, x);
      }
    CHECK(identical(run_sgm(mirrored, penalties, directions), sums_mirrored));
    CHECK(identical(run_sgm(flipped, penalties, directions), sums_flipped));
  }
}

TEST_CASE("a volume without cells gives sums without cells") {
  const CostVolume costs(dense_shape({6, 5}, {0, 0}), 24);
  CHECK(run_sgm(costs, ConstantPenalties(1, 2), 8).shape().cells() == 0);
}

TEST_CASE("sgm tells its progress up to the end") {
  struct Watcher : Observer {
    void progress(double share) override { shares.push_back(share); }
    std::vector<double> shares;
  } watcher;
  const CostVolume costs = random_costs(dense_shape({64, 48}, {0, 16}), 24, 1);
  for (const int count : {1, 2, 5}) {
    CAPTURE(count);
    watcher.shares.clear();
    const xgm::ThreadLimit threads(count);
    testing::stage<Aggregation>("sgm")->run(costs, ConstantPenalties(5, 30), Context(&watcher));
    // Of several threads one tells, after its own lines: how often is not known.
    if (count == 1) CHECK(watcher.shares.size() >= 10);
    CHECK(std::ranges::is_sorted(watcher.shares));
    CHECK(watcher.shares.back() == doctest::Approx(1));
  }
}

TEST_CASE("an exception of penalties ends the run, not the process") {
  struct Faulty final : PenaltyField {
    PenaltyTable table(Direction) const override { return {2, 1, {{1, 2}, {3, 4}}}; }
    void classify(Direction, int y, std::span<std::uint8_t> base,
                  std::span<std::uint8_t> match) const override {
      if (y == 7) throw Error("row 7");
      std::ranges::fill(base, std::uint8_t{0});
      std::ranges::fill(match, std::uint8_t{0});
    }
  };
  const CostVolume costs = random_costs(dense_shape({64, 48}, {0, 16}), 24, 1);
  CHECK_THROWS_WITH(run_sgm(costs, Faulty(), 8), "row 7");
}

TEST_CASE("sgm accepts 4, 8 and 16 directions only") {
  for (const char* good : {"4", "8", "16"})
    CHECK_NOTHROW(
        testing::stage<Aggregation>("{type: sgm, directions: " + std::string(good) + "}"));
  for (const char* bad : {"0", "2", "5", "12", "32", "-8"})
    CHECK_THROWS_AS(
        testing::stage<Aggregation>("{type: sgm, directions: " + std::string(bad) + "}"), Error);
}
