// SPDX-License-Identifier: Apache-2.0
// The chain inside semi_global, with stages that tell what they were given.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

/// What the stages saw, in the order in which they ran.
struct Seen {
  std::vector<std::string> paths;
  VolumeShapePtr shape;
  std::weak_ptr<int> field;  // dies with the penalty field
  bool field_lived_at_selection = false;
};
Seen& seen() {
  static Seen all;
  return all;
}

bool matches(const VolumeShape& shape, int y, int x, int d) {
  return y >= 0 && x - d >= 0 && x - d < shape.width();
}

/// |d - 3|, or no match outside the match image.
class DistanceCost final : public Cost {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit DistanceCost(Parameters) {}
  CostVolume run(const ImagePair&, const VolumeShapePtr& shape,
                 const Context& context) const override {
    seen().paths.push_back(context.path());
    seen().shape = shape;
    CostVolume costs(shape, 100);
    for (int y = 0; y < shape->height(); ++y) {
      for (int x = 0; x < shape->width(); ++x) {
        for (int i = 0; i < shape->count(y, x); ++i) {
          const int d = shape->begin(y, x) + i;
          costs.at(y, x)[i] = matches(*shape, y, x, d) ? static_cast<std::uint8_t>(std::abs(d - 3))
                                                       : CostVolume::kNoMatch;
        }
      }
    }
    return costs;
  }
};

/// Its field keeps a number alive that tells whether the field still lives.
class MortalPenalty final : public Penalty {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit MortalPenalty(Parameters) {}
  std::unique_ptr<const PenaltyField> run(const ImagePair&, const Context& context) const override {
    struct Field final : PenaltyField {
      PenaltyTable table(Direction) const override { return {}; }
      std::shared_ptr<int> life = std::make_shared<int>();
    };
    seen().paths.push_back(context.path());
    auto field = std::make_unique<Field>();
    seen().field = field->life;
    return field;
  }
};

/// Sums are the costs.
template <bool kRagged>
class CopyAggregation final : public Aggregation {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit CopyAggregation(Parameters) {}
  bool accepts_ragged_volumes() const override { return kRagged; }
  AggregatedVolume run(const CostVolume& costs, const PenaltyField&,
                       const Context& context) const override {
    seen().paths.push_back(context.path());
    AggregatedVolume sums(costs.shape_ptr(), 0);
    for (std::int64_t i = 0; i < costs.shape().cells(); ++i) {
      sums.data()[i] =
          costs.data()[i] == CostVolume::kNoMatch ? AggregatedVolume::kNoMatch : costs.data()[i];
    }
    return sums;
  }
};

class LowestSelection final : public Selection {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit LowestSelection(Parameters) {}
  DisparityMap run(const AggregatedVolume& sums, const Context& context) const override {
    seen().paths.push_back(context.path());
    seen().field_lived_at_selection = !seen().field.expired();
    const VolumeShape& shape = sums.shape();
    DisparityMap map(shape.size());
    for (int y = 0; y < shape.height(); ++y) {
      for (int x = 0; x < shape.width(); ++x) {
        const auto* last = sums.at(y, x) + shape.count(y, x);
        const auto* best = std::min_element(sums.at(y, x), last);
        if (best == last || *best == AggregatedVolume::kNoMatch) continue;
        map.set(y, x, static_cast<float>(shape.begin(y, x) + (best - sums.at(y, x))));
      }
    }
    return map;
  }
};

/// Adds a quarter to what is valid.
class QuarterRefinement final : public Refinement {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit QuarterRefinement(Parameters) {}
  DisparityMap run(const DisparityMap& map, const AggregatedVolume&,
                   const Context& context) const override {
    seen().paths.push_back(context.path());
    DisparityMap refined = map.clone();
    refined.disparity += 0.25F;
    return refined;
  }
};

/// d -> factor * d + 1 at every pixel, the masked ones too.
class LinearFilter final : public Filter {
 public:
  struct Parameters {
    double factor = 1;
  };
  static void describe(Parameters& p, ParameterSet& set) { set.add("factor", p.factor, "Factor."); }
  explicit LinearFilter(Parameters parameters) : factor_(static_cast<float>(parameters.factor)) {}
  DisparityMap run(const DisparityMap& map, const ImagePair&,
                   const Context& context) const override {
    seen().paths.push_back(context.path());
    DisparityMap filtered(map.size());
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        const float d = map.has_disparity(y, x) ? map.disparity(y, x) : 0.F;
        filtered.set(y, x, factor_ * d + 1, Status::filled);
      }
    }
    return filtered;
  }

 private:
  float factor_;
};

std::shared_ptr<const Matcher> chain(const std::string& more, const std::string& copy = "copy") {
  Registry registry = Registry::with_builtins();
  registry.add<DistanceCost>("distance", "Fake.");
  registry.add<MortalPenalty>("mortal", "Fake.");
  registry.add<CopyAggregation<true>>("copy", "Fake.");
  registry.add<CopyAggregation<false>>("dense_copy", "Fake.");
  registry.add<LowestSelection>("lowest", "Fake.");
  registry.add<QuarterRefinement>("quarter", "Fake.");
  registry.add<LinearFilter>("linear", "Fake.");
  seen() = {};
  return make_stage<Matcher>(
      "{type: semi_global, cost: distance, penalty: mortal, selection: lowest, aggregation: " +
          copy + more + "}",
      registry);
}

TEST_CASE("semi_global runs its stages in the order in which data flows") {
  const auto matcher = chain(
      ", refinement: quarter, filters: [{type: linear, factor: 10}, {type: linear, factor: 2}]");
  const cv::Size size(9, 3);
  const auto result =
      matcher->run({random_pair(size, 1), DisparityRange::uniform(size, {0, 6}), {}}, Context{});
  const std::vector<std::string> expected{"penalty",    "cost",       "aggregation", "selection",
                                          "refinement", "filters[0]", "filters[1]"};
  CHECK(seen().paths == expected);
  CHECK_FALSE(result.reverse);
  CHECK(result.forward.disparity(1, 8) == ((3 + 0.25F) * 10 + 1) * 2 + 1);
}

TEST_CASE("refinement and filters may be left out") {
  const cv::Size size(9, 3);
  const auto map =
      chain("")
          ->run({random_pair(size, 1), DisparityRange::uniform(size, {0, 6}), {}}, Context{})
          .forward;
  CHECK(map.disparity(1, 8) == 3.F);
  CHECK(map.disparity(1, 2) == 2.F);  // 3 lies outside the match image
}

TEST_CASE("penalties are gone before the sums are read") {
  const cv::Size size(9, 3);
  chain("")->run({random_pair(size, 1), DisparityRange::uniform(size, {0, 6}), {}}, Context{});
  CHECK_FALSE(seen().field_lived_at_selection);
}

/// Disparities of all pixels of the shape that the stages have seen.
std::int64_t matched_cells() {
  const VolumeShape& shape = *seen().shape;
  std::int64_t cells = 0;
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) cells += shape.count(y, x);
  }
  return cells;
}

TEST_CASE("range maps are cut to the match image, which changes no result") {
  for (const cv::Size size : {cv::Size(1, 1), {13, 4}, {40, 3}}) {
    for (const Interval hull : {Interval{-20, 30}, {0, 9}, {-50, -45}, {60, 70}}) {
      const auto matcher = chain("");
      const auto uniform = DisparityRange::uniform(size, hull);
      const DisparityRange map(cv::Mat1i(size, hull.begin), cv::Mat1i(size, hull.end));
      const auto dense = matcher->run({random_pair(size, 1), uniform, {}}, Context{}).forward;
      CHECK(matched_cells() == std::int64_t{size.area()} * hull.size());
      const auto ragged = matcher->run({random_pair(size, 1), map, {}}, Context{}).forward;
      CHECK(identical(dense, ragged));

      std::int64_t matchable = 0;
      for (int x = 0; x < size.width; ++x) {
        for (int d = hull.begin; d < hull.end; ++d) matchable += x - d >= 0 && x - d < size.width;
      }
      CHECK(matched_cells() == matchable * size.height);
    }
  }
}

TEST_CASE("masked pixels have no cells and end as masked, whatever filters do") {
  const cv::Size size(15, 8);
  ImagePair pair = random_pair(size, 1);
  pair.base.valid = random_mask(size, 0.4, 3);
  for (const char* more : {"", ", refinement: quarter", ", filters: [linear]"}) {
    const auto map =
        chain(more)->run({pair, DisparityRange::uniform(size, {0, 6}), {}}, Context{}).forward;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool masked = pair.base.valid(y, x) == 0;
        CHECK(seen().shape->count(y, x) == (masked ? 0 : 6));
        CHECK((map.at(y, x) == Status::masked) == masked);
        CHECK(std::isnan(map.disparity(y, x)) == masked);
      }
    }
  }
}

TEST_CASE("pixels with an empty range end as out_of_range") {
  const cv::Size size(15, 8);
  const auto range = random_range(size, {-3, 6}, 5);
  const auto map = chain("")->run({random_pair(size, 1), range, {}}, Context{}).forward;
  int empty = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (!range.at(y, x).empty()) continue;
      ++empty;
      CHECK(map.at(y, x) == Status::out_of_range);
    }
  }
  CHECK(empty > 0);
}

TEST_CASE("an aggregation that needs one range says so before and while it runs") {
  const cv::Size size(6, 5);
  const auto matcher = chain("", "dense_copy");
  CHECK_FALSE(matcher->accepts_range_maps());
  CHECK(chain("")->accepts_range_maps());
  ImagePair pair = random_pair(size, 1);
  const auto uniform = DisparityRange::uniform(size, {0, 3});
  CHECK_THROWS_AS(matcher->run({pair, random_range(size, {0, 3}, 2), {}}, {}), Error);
  pair.base.valid = cv::Mat1b(size, std::uint8_t{255});
  CHECK_NOTHROW(matcher->run({pair, uniform, {}}, {}));
  pair.base.valid(2, 3) = 0;
  CHECK_THROWS_AS(matcher->run({pair, uniform, {}}, {}), Error);
}

TEST_CASE("progress of semi_global never falls and ends at 1") {
  const cv::Size size(6, 5);
  ProgressObserver observer;
  const auto matcher = chain(", refinement: quarter, filters: [linear, linear]");
  matcher->run({random_pair(size, 1), DisparityRange::uniform(size, {0, 3}), {}},
               Context(&observer));
  CHECK(std::is_sorted(observer.shares.begin(), observer.shares.end()));
  CHECK(observer.shares.back() == doctest::Approx(1));
}

}  // namespace
}  // namespace xgm::testing::matchers
