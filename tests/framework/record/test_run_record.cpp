// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "support/support.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/evaluation/run_record.hpp"

using namespace xgm;

namespace {

StagePlace at(const std::string& path, const std::string& plugin = {}) {
  StagePlace place;
  place.path = path;
  place.plugin = plugin;
  return place;
}

}  // namespace

TEST_CASE("recorder: stages in the order they begin, figures at the call that told them") {
  RunRecorder recorder;
  recorder.stage_begin(at("matcher", "pyramid"));
  recorder.stage_begin(at("matcher.cost", "census"));
  recorder.figure(at("matcher.cost"), "ones", 1);
  recorder.stage_end(at("matcher.cost"), {0.5, 10}, {});
  recorder.stage_begin(at("matcher.cost", "census"));
  recorder.figure(at("matcher.cost"), "ones", 2);
  recorder.stage_end(at("matcher.cost"), {0.25, 20}, {});
  recorder.figure(at("elsewhere"), "lost", 3);
  const auto& stages = recorder.stages();
  REQUIRE(stages.size() == 4);
  CHECK(stages[0].place.path == "matcher");
  CHECK_FALSE(stages[0].finished);
  CHECK(stages[1].statistics.seconds == 0.5);
  CHECK(stages[1].figures[0].second == 1);
  CHECK(stages[2].statistics.bytes == 20);
  CHECK(stages[2].figures[0].second == 2);
  CHECK(stages[3].place.path == "elsewhere");
}

TEST_CASE("run.json tells whose result a stage was given instead of running") {
  RunRecorder recorder;
  recorder.stage_begin(at("matcher.matchers[0]"));
  recorder.stage_end(at("matcher.matchers[0]"), {0.5, 10}, {});
  recorder.stage_begin(at("matcher.matchers[1]"));
  recorder.stage_same_as(at("matcher.matchers[1]"), "matcher.matchers[0]");
  recorder.stage_end(at("matcher.matchers[1]"), {0, 10}, {});
  RunRecord record;
  record.resolved_pipeline = "{}";
  record.stages = recorder.stages();
  const auto stages = nlohmann::json::parse(to_json(record))["stages"];
  CHECK_FALSE(stages[0].contains("same_as"));
  CHECK(stages[1]["same_as"] == "matcher.matchers[0]");
}

TEST_CASE("run.json tells the place of every stage") {
  RunRecord record;
  record.resolved_pipeline = "{}";
  StagePlace place = at("matcher.half.matcher.cost", "census");
  place.kind = "cost";
  place.depth = 2;
  place.view = View::reverse;
  place.level = {"half", 2, "matcher.half"};
  record.stages = {{place, {}, true, {}}, {at("matcher", "x"), {}, true, {}}};
  const auto stages = nlohmann::json::parse(to_json(record))["stages"];
  CHECK(stages[0]["kind"] == "cost");
  CHECK(stages[0]["depth"] == 2);
  CHECK(stages[0]["view"] == "reverse");
  CHECK(stages[0]["level"]["name"] == "half");
  CHECK(stages[0]["level"]["scale"] == 2);
  CHECK_FALSE(stages[1].contains("level"));
}

TEST_CASE("run.json is valid JSON whatever the names and figures are") {
  RunRecord record;
  record.resolved_pipeline = R"({"matcher": {"type": "x"}})";
  record.scene = "name in Latin-1: \xe4";
  record.inputs = {{"left", "a\"b\n.png", {12, "00000000000000ff"}}};
  record.overrides = {{"matcher.scale", "2"}};
  record.disparities = {-3, 5};
  record.stages = {{at("matcher", "x"), {1.5, 100}, true, {{"nan", std::nan("")}}}};
  Evaluation evaluation;
  evaluation.judged = 4;
  evaluation.invalid = 0.25;
  evaluation.average_error = 0.5;
  evaluation.at = {{1, 0.25, 0.5}};
  record.truth = {{"all", evaluation}};
  const auto json = nlohmann::json::parse(to_json(record));
  CHECK(json["pipeline"]["resolved"]["matcher"]["type"] == "x");
  CHECK(json["pipeline"]["overrides"][0]["path"] == "matcher.scale");
  CHECK(json["scene"]["inputs"][0]["file"] == "a\"b\n.png");
  CHECK(json["disparities"]["first"] == -3);
  CHECK(json["disparities"]["last"] == 4);
  CHECK(json["stages"][0]["seconds"] == 1.5);
  CHECK(json["stages"][0]["figures"]["nan"].is_null());
  CHECK(json["truth"][0]["thresholds"][0]["total"] == 0.5);
  CHECK(json["status_shares"].size() == kStatusCount);
  CHECK_FALSE(json["versions"]["opencv"].get<std::string>().empty());
}

TEST_CASE("recorded inputs are read as they were written; sizes that are none are not") {
  RunRecord record;
  record.resolved_pipeline = "{}";
  record.inputs = {{"left", "im0.png", {(std::uint64_t{1} << 60) + 1, "00000000000000ff"}}};
  const std::vector<InputFile> read = recorded_inputs(to_json(record));
  REQUIRE(read.size() == 1);
  CHECK(read[0].role == "left");
  CHECK(read[0].file == "im0.png");
  CHECK(read[0].identity.bytes == (std::uint64_t{1} << 60) + 1);
  CHECK(read[0].identity.fnv1a64 == "00000000000000ff");
  for (const std::string bytes : {"-1", "1e300", "0.5", "\"1\"", "null"}) {
    const std::string text = R"({"scene": {"inputs": [{"role": "r", "file": "f", "fnv1a64": "0", )"
                             R"("bytes": )" +
                             bytes + "}]}}";
    CHECK_MESSAGE(recorded_inputs(text).empty(), bytes);
    const bool unknown = bytes == "null";  // of an output that is still to be written
    const std::string outputs = R"({"outputs": [{"file": "f", "bytes": )" + bytes + "}]}";
    CHECK_MESSAGE(recorded_outputs(outputs).empty() != unknown, bytes);
  }
}

TEST_CASE("memory: the figures are those of a living process") {
  CHECK(peak_memory() > 1'000'000);
  CHECK(available_memory() > 1'000'000);
}
