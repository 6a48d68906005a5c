// SPDX-License-Identifier: Apache-2.0
// Contract of matchers: what they return for every pair that may come.
#include <cmath>

#include "contract_support.hpp"
#include "xgm/testing/synthetic.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

void expect_masked(Report& report, const DisparityMap& map, const Image& view) {
  for (int y = 0; y < view.size().height; ++y) {
    for (int x = 0; x < view.size().width; ++x) {
      report.expect((map.at(y, x) == Status::masked) != view.is_valid(y, x),
                    "status masked is not where there is no data", y, x);
    }
  }
}

void check_on(Report& report, const Matcher& stage, const MatchRequest& request) {
  const Bytes before = bytes_of(request.pair);
  const MatchResult result =
      run_with_threads(report, [&] { return stage.run(request, Context{}); });
  report.expect(bytes_of(request.pair) == before, "the images were changed");
  report.expect_none(Matcher::fault_of(result, request, Context{}));
  if (result.forward.status.size() == request.pair.size()) {
    expect_masked(report, result.forward, request.pair.base);
  }
  if (result.reverse && result.reverse->status.size() == request.pair.size()) {
    expect_masked(report, *result.reverse, request.pair.match);
  }
  for (const float level : {0.0F, 255.0F}) {
    MatchRequest other = request;
    other.pair = with_levels_under_masks(request.pair, level);
    report.expect(bytes_of(stage.run(other, Context{})) == bytes_of(result),
                  "grey levels of masked pixels matter");
  }
}

/// Catches what no bound does: a wrong sign, a shift, both views mixed up.
void check_easy_scene(Report& report, const Matcher& stage, const char* name,
                      Interval disparities) {
  SceneOptions options;
  options.size = {120, 90};
  options.disparities = disparities;
  options.objects = 2;
  const SyntheticScene scene = make_scene(options);
  report.with(name, [&] {
    const MatchRequest request{scene.pair, DisparityRange::uniform(options.size, disparities), {}};
    const MatchResult result = stage.run(request, Context{});
    report.expect_none(Matcher::fault_of(result, request, Context{}));
    const DisparityMap& map = result.forward;
    if (map.size() != options.size) return;
    int visible = 0, right = 0;
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (scene.non_occluded(y, x) == 0) continue;
        ++visible;
        if (std::abs(map.disparity(y, x) - scene.truth(y, x)) <= 1) ++right;
      }
    }
    report.expect(2 * right > visible, "fewer than half of the visible pixels are right");
  });
}

/// A family as the matcher that it is to its callers.
class FamilyMatcher final : public Matcher {
 public:
  explicit FamilyMatcher(const StereoFamily& family) : family_(family) {}
  MatchResult run(const MatchRequest& request, const Context& context) const override {
    return family_.run(request, context);
  }
  bool accepts_range_maps() const override { return family_.accepts_range_maps(); }

 private:
  const StereoFamily& family_;
};

}  // namespace

Violations check_matcher(const Matcher& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    if (!input.range.is_uniform() && !stage.accepts_range_maps()) continue;
    report.with(input.name, [&] { check_on(report, stage, {input.pair, input.range, {}}); });
  }
  const Input usual = inputs().front();
  report.with("empty range", [&] {
    check_on(report, stage, {usual.pair, DisparityRange::uniform(usual.pair.size(), {5, 5}), {}});
  });
  check_easy_scene(report, stage, "easy scene", {0, 16});
  check_easy_scene(report, stage, "easy scene below zero", {-14, 2});
  return report.take();
}

Violations check_pipeline(const StereoFamily& stage, const Watch& watch) {
  return check_matcher(FamilyMatcher(stage), watch);
}

}  // namespace xgm::testing
