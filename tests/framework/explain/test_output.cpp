// SPDX-License-Identifier: Apache-2.0
// Explanations as text and JSON, the truth in them, and what an Explainer refuses.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "framework/explain/explained.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

Explained refined(const SyntheticScene& scene) {
  const LoadedPipeline pipeline =
      load_pipeline(XGM_SOURCE_DIR "/pipelines/tmgm16_refined.yaml", builtins());
  return explain_all(*pipeline.pipeline, scene.pair,
                     DisparityRange::uniform(scene.pair.size(), scene.disparities), scene.truth);
}

}  // namespace

TEST_CASE("JSON holds the complete curves, null where nothing matches, and reads as it was") {
  const Explained explained = refined(small_scene());
  const auto json = nlohmann::json::parse(to_json(explained.pixels));
  REQUIRE(json.size() == explained.pixels.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Explanation& pixel = explained.pixels[i];
    REQUIRE(json[i]["x"] == pixel.pixel.x);
    REQUIRE(json[i]["y"] == pixel.pixel.y);
    REQUIRE(json[i]["disparity"].is_null() == std::isnan(pixel.result.disparity));
    if (!json[i]["disparity"].is_null()) {
      REQUIRE(json[i]["disparity"].get<float>() == pixel.result.disparity);
    }
    REQUIRE(json[i]["levels"].size() == pixel.levels.size());
    for (std::size_t k = 0; k < pixel.levels.size(); ++k) {
      const MatchExplanation& match = pixel.levels[k].forward;
      const auto& level = json[i]["levels"][k];
      if (match.range.empty()) {
        REQUIRE(level["range"].is_null());
        continue;
      }
      REQUIRE(level["range"] == nlohmann::json{match.range.begin, match.range.end - 1});
      for (const auto& [name, curve] : {std::pair("costs", match.costs), {"sums", match.sums}}) {
        REQUIRE(level[name].size() == curve.size());
        for (std::size_t d = 0; d < curve.size(); ++d) {
          REQUIRE(level[name][d].is_null() == std::isnan(curve[d]));
          if (!std::isnan(curve[d])) REQUIRE(level[name][d].get<float>() == curve[d]);
        }
      }
    }
  }
}

TEST_CASE("the text is ASCII, at most 100 columns wide, and ends with the reason") {
  const SyntheticScene wide =
      make_scene({.size = {400, 6}, .disparities = {-20, 250}, .shift = {}});
  for (const Explained& explained : {refined(small_scene()), refined(wide)}) {
    for (const Explanation& pixel : explained.pixels) {
      const std::string text = to_text(pixel);
      REQUIRE(std::all_of(text.begin(), text.end(),
                          [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
      std::istringstream lines(text);
      std::string line, last_start;
      while (std::getline(lines, line)) {
        CAPTURE(line);
        REQUIRE(line.size() <= 100);
        if (!line.starts_with(" ") && !line.empty()) last_start = line;
      }
      REQUIRE(last_start.starts_with("why: "));
    }
  }
}

TEST_CASE("the truth is compared with the winner, and the diagnosis says where it was lost") {
  SyntheticScene scene = small_scene();
  const std::string yaml =
      "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 24, p2: 96}, "
      "aggregation: {type: sgm, directions: 4}}";
  SUBCASE("right") {
    int right = 0;
    for (const Explanation& pixel : explain_all(yaml, scene).pixels) {
      REQUIRE(*pixel.truth == scene.truth(pixel.pixel));
      const auto& truth = *pixel.levels.front().forward.truth;
      REQUIRE(truth.disparity == *pixel.truth);
      REQUIRE(truth.searched);
      const bool close = std::abs(pixel.result.disparity - *pixel.truth) <= 1;
      REQUIRE(close == pixel.diagnosis.starts_with("right"));
      right += close;
      const MatchExplanation& match = pixel.levels.front().forward;
      if (close || std::isnan(truth.nearest.cost)) continue;
      const bool by_cost = match.winner->cost < truth.nearest.cost;
      REQUIRE(pixel.diagnosis.starts_with(by_cost ? "cost: " : "aggregation: "));
    }
    CHECK(right > 2000);
  }
  SUBCASE("outside of the range") {
    scene.truth += 20;
    for (const Explanation& pixel : explain_all(yaml, scene).pixels) {
      REQUIRE_FALSE(pixel.levels.front().forward.truth->searched);
      REQUIRE(pixel.diagnosis.starts_with("range: s1 searched 0 to 11, the truth is "));
    }
  }
  SUBCASE("unknown") {
    scene.truth = NAN;
    const Explanation pixel = explain_all(yaml, scene).at(5, 5);
    CHECK_FALSE(pixel.truth.has_value());
    CHECK(pixel.diagnosis.empty());
  }
}

TEST_CASE("long ranges are binned, and every mark is drawn") {
  const SyntheticScene scene = make_scene({.size = {400, 6}, .disparities = {0, 260}, .shift = {}});
  const Explained explained = explain_all(
      "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 24, p2: 96}, "
      "aggregation: {type: sgm, directions: 4}}",
      scene);
  const std::string text = to_text(explained.at(3, 300));
  CHECK(contains(text, "the lowest of 4 disparities"));
  CHECK(contains(text, "W"));
}

TEST_CASE("pixels outside of the image, and a truth of another size, are refused") {
  const std::string outside = error_of([] { Explainer({20, 10}, {{20, 3}}); });
  CHECK(contains(outside, "pixel 20 3 lies outside of the images, which are 20 x 10 pixels"));
  CHECK(contains(error_of([] { Explainer({20, 10}, {{-1, 3}}); }), "lies outside"));
  CHECK(contains(error_of([] { Explainer({20, 10}, {}, cv::Mat1f(3, 3)); }), "not of the images'"));
}

TEST_CASE("a grid has a pixel in every cell, and never none") {
  CHECK(pixel_grid({3, 2}, 1).size() == 6);
  CHECK(pixel_grid({3, 2}, 1).front() == cv::Point(0, 0));
  CHECK(pixel_grid({10, 10}, 4) == std::vector<cv::Point>{{2, 2}, {6, 2}, {2, 6}, {6, 6}});
  CHECK(pixel_grid({3, 2}, 100) == std::vector<cv::Point>{{2, 1}});
  CHECK(contains(error_of([] { pixel_grid({3, 2}, 0); }), "at least one pixel"));
}

TEST_CASE("the truth's costs are told where there are some") {
  const Explained explained = explain_all(
      "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 24, p2: 96}, "
      "aggregation: {type: sgm, directions: 4}}",
      small_scene());
  Explanation pixel = explained.at(5, 30);
  MatchExplanation& match = pixel.levels.front().forward;
  REQUIRE(match.truth->searched);
  CHECK(contains(to_text(pixel), " has cost "));
  match.truth->nearest.cost = match.truth->nearest.sum = NAN;
  const std::string nearest = std::to_string(match.truth->nearest.disparity);
  CHECK(contains(to_text(pixel), ": searched; " + nearest + " cannot be matched\n"));
  match.costs.clear();
  match.sums.clear();
  CHECK(contains(to_text(pixel), ": searched\n"));
}
