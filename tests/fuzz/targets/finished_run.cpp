// SPDX-License-Identifier: Apache-2.0
// The run.json of a finished run, as a bench and its page read it.
#include <cmath>

#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::fuzz {
namespace {

BenchRequest request_in(const std::string& output) {
  BenchRequest request;
  request.output = output;
  request.pipelines = {{.name = "p", .file = "p.yaml", .overrides = {}, .resolved = "{}"}};
  request.scenes = {{.set = "s", .data_folder = output, .files = {.name = "one"}}};
  return request;
}

/// Judges the run whose record is `run_json`.
void check_bench(const std::string& run_json) {
  static const testing::TemporaryFolder folder;
  const auto run = [&](const BenchPipeline&, const BenchScene&, const std::string& cell) {
    write_pfm(cell + "/disparity.pfm", cv::Mat1f(1, 2, 1.0F));
    std::ofstream(cell + "/run.json", std::ios::binary) << run_json;
    return RunOutcome{};
  };
  const BenchHooks hooks{.run = run};
  const BenchRequest request = request_in(folder.path());
  const BenchResult result = run_bench(request, {}, hooks);
  const BenchCell& cell = result.at(0, 0);
  if (cell.state == CellState::failed) {
    require(cell.failure.find("run.json") != std::string::npos, "a failure names the file");
  } else {
    for (const double figure : {cell.seconds, cell.peak_bytes, cell.evaluations, cell.density}) {
      require(std::isfinite(figure) && figure >= 0, "a figure of a run is a number from 0 on");
    }
  }
  require(!bench_csv(result).empty() && !bench_json(result).empty(), "there are tables");
}

/// Shows a record, and explanations, that may say anything.
void check_page(const std::string& run_json) {
  DisparityMap map({2, 1});
  map.set(0, 0, 1);
  ReportRun run{.name = "p", .record_json = run_json, .map = map, .levels = {}};
  run.explanations_json = run_json;
  Report report{.title = "t", .scenes = {{"s", Image(cv::Mat1f(1, 2, 0.F)), {}, {run}}}};
  accepts("report", [&] { require(!report_html(report).empty(), "there is a page"); });
}

}  // namespace

void check(std::string_view input) {
  const std::string text(input);
  check_bench(text);
  check_page(text);
}

std::vector<std::string> seeds() {
  RunRecord record;
  record.resolved_pipeline = R"({"xgm": 1, "matcher": {"type": "m", "cost": {"type": "c"}}})";
  record.disparities = {0, 64};
  record.inputs = {{"left", "im0.png", {123, "0123456789abcdef"}}};
  StageRecord stage;
  stage.place.path = "matcher";
  stage.finished = true;
  stage.figures = {{"rounds", 2}};
  record.stages = {stage};
  return {to_json(record),
          R"([{"x": 1, "y": 0, "levels": [{"scale": 1, "range": [0, 3], "costs": [1, 2, null, 4],)"
          R"( "sums": [4, 3, 2, 1], "winner": 1, "runner_up": 2}]}])"};
}

std::vector<std::string> words() {
  return {"\"seconds\":",
          "\"matching\":",
          "\"scene\":",
          "\"width\":",
          "\"stages\":",
          "\"truth\":",
          "\"disparities\":",
          "\"first\":",
          "\"last\":",
          "\"levels\":",
          "\"costs\":",
          "1e308",
          "\"valid_share\":",
          "\"peak_memory_bytes\":",
          "\"pipeline\":",
          "\"resolved\":",
          "-1",
          "[[[[[[[[",
          "null",
          "</script>"};
}

}  // namespace xgm::fuzz
