// SPDX-License-Identifier: Apache-2.0
// Levels of pyramids: collected from a run, shown with what they searched.
#include <doctest/doctest.h>

#include "framework/report/page.hpp"
#include "support/support.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const std::string kMatch =
    "{type: left_right, matcher: {type: semi_global, cost: census, penalty: constant, "
    "aggregation: {type: sgm, directions: 4}}}";

std::vector<ReportLevel> levels_of(const std::string& matcher, const ImagePair& pair) {
  const LoadedPipeline loaded =
      load_pipeline_text("matcher: " + matcher, "p", Registry::with_builtins());
  REQUIRE(loaded.pipeline);
  LevelCollector collector;
  loaded.pipeline->run({pair, DisparityRange::uniform(pair.size(), {0, 16}), {}},
                       {.observer = &collector});
  return collector.levels();
}

}  // namespace

TEST_CASE("report: a pyramid's levels are collected coarsest first, of the base view") {
  const ImagePair pair = shifted_pair({61, 37}, 5, 3);
  const auto levels = levels_of("{type: pyramid, scale: 4, matcher: " + kMatch + "}", pair);
  REQUIRE(levels.size() == 3);
  CHECK(levels[0].level.scale == 4);
  CHECK(levels[0].map.size() == cv::Size(16, 10));
  REQUIRE(levels[0].range);
  CHECK(levels[0].range->hull() == Interval{0, 5});  // 0 to 15 at a quarter, rounded outwards
  CHECK(levels[1].map.size() == cv::Size(31, 19));
  CHECK(levels[2].level.path == "matcher.s1");
  CHECK(levels[2].map.disparity(18, 40) == 5);  // the reverse view has -5
  REQUIRE(levels[2].range);
  CHECK(levels[2].range->at(18, 40).contains(5));
}

TEST_CASE("report: without a pyramid there are no levels") {
  CHECK(levels_of(kMatch, shifted_pair({40, 20}, 3, 3)).empty());
}

TEST_CASE("report: what a level searched is shown, pixel by pixel") {
  ReportScene scene = random_scene({8, 4}, 0, 9, 1);
  cv::Mat1i begin(2, 4, -3), end(2, 4, 4);
  end(1, 2) = -3;  // nothing to search
  scene.runs[0].levels = {
      {{"s4", 4, "matcher.s4"}, "matcher.s4.matcher", DisparityMap({2, 1}), std::nullopt},
      {{"s2", 2, "matcher.s2"},
       "matcher.s2.matcher",
       DisparityMap({4, 2}),
       DisparityRange(begin, end)}};
  const auto levels = page_data(report_html({"t", "", {scene}}))["scenes"][0]["runs"][0]["levels"];
  REQUIRE(levels.size() == 2);
  CHECK_FALSE(levels[0].contains("first"));
  CHECK(unpacked(levels[1]["first"])(0, 0) == -3);
  CHECK(unpacked(levels[1]["last"])(0, 0) == 3);
  CHECK(std::isnan(unpacked(levels[1]["last"])(1, 2)));
}
