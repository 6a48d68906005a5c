// SPDX-License-Identifier: Apache-2.0
// Curves, winners and ranges of an explanation are those of the stages themselves.
#include <cmath>
#include <map>

#include "framework/explain/explained.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const char* const kCost = "{type: census, window: 5}";
const char* const kPenalty = "{type: constant, p1: 24, p2: 96}";
const char* const kAggregation = "{type: mgm, directions: 8, overcounting_correction: true}";

std::string semi_global() {
  return std::string("type: semi_global, cost: ") + kCost + ", penalty: " + kPenalty +
         ", aggregation: " + kAggregation + ", refinement: parabola";
}

/// The cells of one pixel against a curve over its whole range.
template <class Cells>
bool same_curve(const Cells& volume, double units, int y, int x, const MatchExplanation& match,
                const std::vector<float>& curve) {
  if (static_cast<int>(curve.size()) != match.range.size()) return false;
  const VolumeShape& shape = volume.shape();
  for (int d = match.range.begin; d < match.range.end; ++d) {
    const float shown = curve[static_cast<std::size_t>(d - match.range.begin)];
    const bool inside = shape.begin(y, x) <= d && d < shape.end(y, x);
    const auto cell = inside ? volume.at(y, x)[d - shape.begin(y, x)] : volume.kNoMatch;
    if (cell == volume.kNoMatch ? !std::isnan(shown) : shown != double(cell) / units) return false;
  }
  return true;
}

/// By the definition: of all cells that are neither the winner nor beside it, that do not lie in
/// one flat bottom with it, and from which one can walk over equal cells to higher ones on both
/// sides, the lowest; of equal ones the first.
std::optional<int> naive_runner_up(const std::vector<float>& sums, Interval range, int winner) {
  const auto height = [&](int d) {
    if (!range.contains(d)) return double(INFINITY);
    const float sum = sums[static_cast<std::size_t>(d - range.begin)];
    return std::isnan(sum) ? double(INFINITY) : double(sum);
  };
  std::optional<int> best;
  for (int d = range.begin; d < range.end; ++d) {
    if (height(d) == INFINITY) continue;
    int first = d, last = d;
    while (height(first - 1) == height(d)) --first;
    while (height(last + 1) == height(d)) ++last;
    const bool minimum = height(first - 1) > height(d) && height(last + 1) > height(d);
    const bool beside = first <= winner + 1 && last >= winner - 1;
    if (minimum && !beside && (!best || height(d) < height(*best))) best = d;
  }
  return best;
}

/// The shapes of the volumes that a run makes, by the path of their stage.
class Shapes : public Observer {
 public:
  void stage_end(const StagePlace& place, const StageStatistics&, const Artifact& result) override {
    if (const auto* costs = std::get_if<const CostVolume*>(&result)) {
      shapes.emplace(place.path, (*costs)->shape_ptr());
    }
  }
  std::map<std::string, VolumeShapePtr> shapes;
};

}  // namespace

TEST_CASE(
    "costs, sums, winner, runner-up and shift are what the stages give when called directly") {
  const SyntheticScene scene = small_scene();
  const Explained explained = explain_all("matcher: {" + semi_global() + "}", scene);
  const Context context;
  const auto shape = std::make_shared<const VolumeShape>(
      DisparityRange::uniform(scene.pair.size(), scene.disparities));
  const CostVolume costs = stage<Cost>(kCost)->run(scene.pair, shape, context);
  const auto penalties = stage<Penalty>(kPenalty)->run(scene.pair, context);
  const AggregatedVolume sums = stage<Aggregation>(kAggregation)->run(costs, *penalties, context);
  const DisparityMap chosen = stage<Selection>("wta")->run(sums, context);
  const DisparityMap refined = stage<Refinement>("parabola")->run(chosen, sums, context);
  int runner_ups = 0;
  for (const Explanation& pixel : explained.pixels) {
    const int y = pixel.pixel.y, x = pixel.pixel.x;
    REQUIRE(pixel.levels.size() == 1);
    const MatchExplanation& match = pixel.levels.front().forward;
    REQUIRE(match.range == scene.disparities);
    REQUIRE(same_curve(costs, 1, y, x, match, match.costs));
    REQUIRE(same_curve(sums, 1 << sums.fraction_bits, y, x, match, match.sums));
    REQUIRE(match.winner.has_value());
    REQUIRE(match.winner->disparity == static_cast<int>(chosen.disparity(y, x)));
    REQUIRE(match.shift == refined.disparity(y, x) - chosen.disparity(y, x));
    const auto second = naive_runner_up(match.sums, match.range, match.winner->disparity);
    REQUIRE(match.runner_up.has_value() == second.has_value());
    if (!second) continue;
    ++runner_ups;
    REQUIRE(match.runner_up->disparity == *second);
    REQUIRE(match.runner_up->sum == match.sums[static_cast<std::size_t>(*second)]);
  }
  CHECK(runner_ups > 100);
}

TEST_CASE("the range of each level is what its volume was made for") {
  const SyntheticScene scene = small_scene();
  const Pipeline pipeline =
      loaded("matcher: {type: pyramid, scale: 4, matcher: {type: left_right, matcher: {" +
             semi_global() + "}}}");
  const DisparityRange range = DisparityRange::uniform(scene.pair.size(), scene.disparities);
  const Explained explained = explain_all(pipeline, scene.pair, range);
  Shapes recorder;
  pipeline.run({scene.pair, range, std::nullopt}, {.observer = &recorder});
  REQUIRE(recorder.shapes.size() == 6);
  for (const Explanation& pixel : explained.pixels) {
    REQUIRE(pixel.levels.size() == 3);
    int shift = 2;
    for (const LevelExplanation& level : pixel.levels) {
      REQUIRE(level.level.scale == 1 << shift);
      const cv::Point at = level.forward.pixel;
      REQUIRE(at == cv::Point(pixel.pixel.x >> shift, pixel.pixel.y >> shift));
      const std::string name = "matcher.s" + std::to_string(1 << shift) + ".matcher";
      const auto check = [&](const MatchExplanation& match, const std::string& view) {
        const VolumeShape& shape = *recorder.shapes.at(name + "." + view + ".matcher.cost");
        const int y = match.pixel.y, x = match.pixel.x;
        // What lies outside the other image has no cells where ranges differ between pixels.
        const Interval inside = intersect(match.range, {x - shape.width() + 1, x + 1});
        const Interval cells = shift == 2 ? match.range : inside;
        REQUIRE(cells.size() == shape.count(y, x));
        if (!cells.empty()) REQUIRE(cells.begin == shape.begin(y, x));
      };
      check(level.forward, "forward");
      if (level.reverse) check(*level.reverse, "reverse");
      --shift;
    }
  }
}
