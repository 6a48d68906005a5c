// SPDX-License-Identifier: Apache-2.0
// Times of pipelines: what is summed up, and what the tables say.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "speed/stage_clock.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/evaluation/speed.hpp"

using namespace xgm;
using xgm::testing::builtins;
using xgm::testing::contains;

namespace {

/// Two contestants whose figures are easily checked.
SpeedResult known_result() {
  SpeedResult result{{}, {1000, 500}, {0, 20}, {}};
  result.race.threads = 2;
  result.race.rounds = 3;
  result.times = {
      {.name = "ours",
       .simd = "avx2",
       .seconds = {0.5, 0.25, 9},
       .cpu_seconds = {1, 0.5, 0.75},
       .stages = {{"cost census", {0.1, 0.2, 0.1}}, {"aggregation sgm", {0.3, 0.3, 9}}}},
      {.name = "OpenCV HH", .simd = "", .seconds = {1, 2, 3}, .cpu_seconds = {1, 2, 3}},
      {.name = "OpenCV HH4", .simd = "", .failure = "too small"}};
  return result;
}

SpeedRace small_plan() {
  const char* yaml =
      "xgm: 1\n"
      "matcher:\n"
      "  type: semi_global\n"
      "  cost: census\n"
      "  penalty: {type: constant, p1: 24, p2: 96}\n"
      "  aggregation: {type: sgm, directions: 4}\n"
      "  filters: [{type: median, window: 3}, {type: median, window: 5}]\n";
  SpeedRace race;
  race.pipelines.push_back({"small", *load_pipeline_text(yaml, "small.yaml", builtins()).pipeline});
  race.simd = simd_targets();
  race.rounds = 2;
  return race;
}

MatchRequest small_request(cv::Size size) {
  const ImagePair pair = xgm::testing::shifted_pair(size, 3, 1);
  return {pair, DisparityRange::uniform(size, {-2, 9}), {}};
}

SpeedResult timed(const SpeedRace& race, const MatchRequest& request) {
  return time_pipelines(race, request, [](const std::string&) {});
}

}  // namespace

TEST_CASE("a stage's time does not hold that of the stages inside, and views and levels add up") {
  speed::StageClock clock;
  StagePlace matcher, filter;
  matcher.kind = "matcher";
  matcher.plugin = "left_right";
  filter.kind = "filter";
  filter.plugin = "median";
  clock.stage_begin(matcher);
  for (const View view : {View::forward, View::reverse}) {
    filter.view = view;
    clock.stage_begin(filter);
    clock.stage_end(filter, {2, 0}, {});
  }
  clock.stage_end(matcher, {5, 0}, {});
  REQUIRE(clock.totals().size() == 2);
  CHECK(clock.totals()[0].stage == "matcher left_right");
  CHECK(clock.totals()[0].seconds == doctest::Approx(1));
  CHECK(clock.totals()[1].stage == "filter median");
  CHECK(clock.totals()[1].seconds == doctest::Approx(4));
}

TEST_CASE("the median is the value in the middle, or the mean of two") {
  CHECK(median({}) == 0);
  CHECK(median({3}) == 3);
  CHECK(median({9, 1, 2}) == 2);
  CHECK(median({4, 1, 9, 2}) == 3);
}

TEST_CASE("tables have medians, evaluations per second, ratios and shares") {
  const std::string text = speed_markdown(known_result());
  CAPTURE(text);
  CHECK(contains(text, "1000 x 500 px, 20 disparities, 2 threads, medians of 3 rounds\n"));
  CHECK(contains(text,
                 "| ours       | avx2    | 0.500 |   0.250 | 0.750 |    20 | 4.00 |     - |\n"));
  CHECK(contains(text,
                 "| OpenCV HH  | its own | 2.000 |   1.000 | 2.000 |     5 | 1.00 |     - |\n"));
  CHECK(contains(text, "OpenCV HH4 was not timed: too small\n"));
  CHECK(contains(text, "| cost census           | 0.100 | 25.0 |\n"));
  CHECK(contains(text, "| aggregation sgm       | 0.300 | 75.0 |\n"));
}

TEST_CASE("programs get every round") {
  const auto json = nlohmann::json::parse(speed_json(known_result()));
  CHECK(json["threads"] == 2);
  CHECK(json["disparities"]["last"] == 19);
  CHECK(json["times"][0]["median_seconds"] == 0.5);
  CHECK(json["times"][0]["seconds"].size() == 3);
  CHECK(json["times"][0]["stages"][1]["stage"] == "aggregation sgm");
  CHECK(json["times"][1]["simd"].is_null());
  CHECK(json["times"][2]["median_seconds"].is_null());
  CHECK(json["times"][2]["failure"] == "too small");
}

TEST_CASE("every target and every mode of OpenCV is timed in every round") {
  SpeedRace race = small_plan();
  race.peers = opencv_modes();
  const std::string before = simd_target();
  const SpeedResult result = timed(race, small_request({61, 23}));
  CHECK(simd_target() == before);
  REQUIRE(result.times.size() == simd_targets().size() + 4);
  for (const SpeedTimes& times : result.times) {
    CAPTURE(times.name);
    CHECK(times.failure == "");
    CHECK(times.seconds.size() == 2);
    CHECK(times.cpu_seconds.size() == 2);
  }
  const SpeedTimes& first = result.times.front();
  CHECK(first.simd == simd_targets().front());
  REQUIRE(first.stages.size() == 7);
  CHECK(first.stages[5].stage == "filter median");
  double sum = 0;
  for (const StageSeconds& stage : first.stages) sum += stage.seconds[1];
  CHECK(sum == doctest::Approx(first.seconds[1]));
}

TEST_CASE("what OpenCV cannot match is noted, and the pipelines are timed all the same") {
  SpeedRace race = small_plan();
  race.peers = {"hh"};
  const SpeedResult result = timed(race, small_request({16, 8}));
  CHECK(contains(result.times.back().failure, "no wider than the search range"));
  CHECK(result.times.back().seconds.empty());
  CHECK(result.times.front().seconds.size() == 2);
}

TEST_CASE("what does not exist is refused before anything is timed") {
  bool told = false;
  const auto tell = [&](const std::string&) { told = true; };
  SpeedRace race = small_plan();
  race.peers = {"hhh"};
  CHECK_THROWS_AS(time_pipelines(race, small_request({16, 8}), tell), Error);
  race = small_plan();
  race.simd = {"mmx"};
  CHECK_THROWS_AS(time_pipelines(race, small_request({16, 8}), tell), Error);
  MatchRequest mapped = small_request({4, 1});
  mapped.range = DisparityRange(cv::Mat1i(1, 4, 0), cv::Mat1i(1, 4, 2));
  CHECK_THROWS_AS(time_pipelines(small_plan(), mapped, tell), Error);
  CHECK_FALSE(told);
}
