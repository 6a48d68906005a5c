// SPDX-License-Identifier: Apache-2.0
// Two output folders compared: records, and what one of them lacks.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/run_diff.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

/// A record of a run of `scale` on a left image of this hash.
std::string record(int scale, const std::string& hash, const std::string& extra = {}) {
  return R"({"versions": {"xgm": "0.1.0"}, "pipeline": {"resolved": {"matcher": {"type": "pyramid",
    "scale": )" +
         std::to_string(scale) + extra + R"(, "filters": [{"type": "median"}]}}},
    "disparities": {"first": 0, "last": 63, "from": "caller"}, "threads": )" +
         std::to_string(scale) + R"(, "seconds": {"matching": 1.5},
    "scene": {"inputs": [{"role": "left", "file": "/a/)" +
         hash + R"(.png", "bytes": 7, "fnv1a64": ")" + hash + R"("}]}})";
}

struct Runs : TemporaryFolder {
  Runs() {
    for (const char* name : {"a", "b", "empty"}) std::filesystem::create_directory(*this / name);
  }
  void map(const std::string& run, cv::Size size, float d) const {
    write_pfm(*this / (run + "/disparity.pfm"), cv::Mat1f(size, d));
  }
  RunDiff diff() const { return compare_runs(*this / "a", *this / "b", 0); }
};

bool has(const std::vector<Difference>& list, const std::string& what, const std::string& first,
         const std::string& second) {
  return std::ranges::any_of(list, [&](const Difference& difference) {
    return difference.what == what && difference.first == first && difference.second == second;
  });
}

}  // namespace

TEST_CASE("diff of runs: equal runs are the same, however many threads they had") {
  const Runs runs;
  for (const char* run : {"a", "b"}) runs.map(run, {8, 4}, 3);
  runs.write("a/run.json", record(4, "11"));
  runs.write("b/run.json", record(4, "11"));
  CHECK(runs.diff().same());
  CHECK(contains(diff_text(runs.diff()), "the runs are the same"));
}

TEST_CASE("diff of runs: parameters, inputs by content, and the map are told") {
  const Runs runs;
  runs.map("a", {8, 4}, 3);
  runs.map("b", {8, 4}, 5);
  runs.write("a/run.json", record(4, "11"));
  runs.write("b/run.json", record(8, "22", ", \"window\": 7"));
  const RunDiff diff = runs.diff();
  CHECK_FALSE(diff.same());
  CHECK(diff.configuration.size() == 2);
  CHECK(has(diff.configuration, "matcher.scale", "4", "8"));
  CHECK(has(diff.configuration, "matcher.window", kNoFigure, "7"));
  CHECK(has(diff.inputs, "left", "/a/11.png (11)", "/a/22.png (22)"));
  CHECK(diff.program.empty());
  CHECK(has(diff.figures, "threads", "4", "8"));
  REQUIRE(diff.map.has_value());
  CHECK(diff.map->moved == 32);
  const std::string text = diff_text(diff);
  CHECK(contains(text, "matcher.scale: 4 -> 8"));
  CHECK(contains(text, "differing: 32 px (100.000 %), in x 0 to 7, y 0 to 3"));
  CHECK(contains(text, "the runs differ"));
}

TEST_CASE("diff of runs: the same content under another name is the same input") {
  const Runs runs;
  std::string moved = record(4, "11");
  moved.replace(moved.find("/a/11.png"), 9, "/b/xx.png");
  runs.write("a/run.json", record(4, "11"));
  runs.write("b/run.json", moved);
  CHECK(runs.diff().inputs.empty());
}

TEST_CASE("diff of runs: what one run lacks is a difference, what both lack is a note") {
  const Runs runs;
  runs.map("a", {8, 4}, 3);
  runs.map("b", {8, 4}, 3);
  const RunDiff no_records = runs.diff();
  CHECK(no_records.same());
  CHECK(no_records.notes == std::vector<std::string>{"neither run has run.json"});
  runs.write("a/run.json", record(4, "11"));
  const RunDiff one_record = runs.diff();
  CHECK_FALSE(one_record.same());
  CHECK(has(one_record.files, "run.json", "is there", kNoFigure));
  CHECK(one_record.configuration.empty());
}

TEST_CASE("diff of runs: confidences are compared where anything counts, and may be missing") {
  const Runs runs;
  cv::Mat1f confidence(4, 8, 0.5f);
  for (const char* run : {"a", "b"}) {
    runs.map(run, {8, 4}, 3);
    runs.write(std::string(run) + "/run.json", record(4, "11"));
  }
  CHECK(runs.diff().same());  // without any
  write_pfm(runs / "a/confidence.pfm", confidence);
  CHECK(has(runs.diff().files, "confidence.pfm", "is there", kNoFigure));
  write_pfm(runs / "b/confidence.pfm", confidence);
  CHECK(runs.diff().same());
  confidence(2, 5) = 0.25f;
  write_pfm(runs / "b/confidence.pfm", confidence);
  const RunDiff diff = runs.diff();
  CHECK_FALSE(diff.same());
  REQUIRE(diff.confidence);
  CHECK(diff.confidence->moved == 1);
  CHECK(diff.confidence->largest == doctest::Approx(0.25));
  CHECK(
      contains(diff_text(diff), "confidence:\n  differing: 1 px (3.125 %), in x 5 to 5, y 2 to 2"));
  CHECK(compare_runs(runs / "a", runs / "b", 0.5).same());
}

TEST_CASE("diff of runs: maps of two sizes differ, without a count of pixels") {
  const Runs runs;
  runs.map("a", {8, 4}, 3);
  runs.map("b", {9, 4}, 3);
  const RunDiff diff = runs.diff();
  CHECK_FALSE(diff.same());
  CHECK_FALSE(diff.map.has_value());
  CHECK(has(diff.map_size, "size", "8 x 4 px", "9 x 4 px"));
}

TEST_CASE(
    "diff of runs: folders that hold no run, and damaged records, are errors that name them") {
  const Runs runs;
  runs.map("a", {8, 4}, 3);
  const auto error = [&](const char* second) {
    return error_of([&] { compare_runs(runs / "a", runs / second, 0); });
  };
  CHECK(contains(error("missing"), runs / "missing" + ": is no folder"));
  CHECK(contains(error("empty"), "has neither run.json nor disparity.pfm"));
  runs.write("b/run.json", "{\"versions\": ");
  CHECK(contains(error("b"), "b/run.json: is no record of a run"));
  runs.write("a/run.json", record(4, "11"));
  runs.write("b/run.json", R"({"scene": {"inputs": [7]}})");
  CHECK(contains(error("b"), "run.json is no record of a run"));
}
