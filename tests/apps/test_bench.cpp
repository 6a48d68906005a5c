// SPDX-License-Identifier: Apache-2.0
// pipeline bench, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench_process.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

constexpr int kDisparity = 3;

std::string flat_pipeline(const std::string& p1) {
  return "xgm: 1\n"
         "matcher:\n"
         "  type: left_right\n"
         "  consistency: lrrl\n"
         "  matcher:\n"
         "    type: semi_global\n"
         "    cost: {type: census, window: 5}\n"
         "    penalty: {type: constant, p1: " +
         p1 +
         ", p2: 20}\n"
         "    aggregation: {type: sgm, directions: 4}\n";
}

/// Pipelines a and b, and the scenes one and two, whose disparity is kDisparity everywhere.
struct Desk : TemporaryFolder {
  Desk() {
    write("a.yaml", flat_pipeline("4"));
    write("b.yaml", flat_pipeline("5"));
    add_scene("one", 5);
    add_scene("two", 6);
  }
  void add_scene(const std::string& name, std::uint64_t seed) const {
    const std::string folder = "trainingQ/" + name;
    fs::create_directories(*this / folder);
    const ImagePair pair = xgm::testing::shifted_pair({40, 24}, kDisparity, seed);
    write_png(*this / (folder + "/im0.png"), picture(pair.base));
    write_png(*this / (folder + "/im1.png"), picture(pair.match));
    write(folder + "/calib.txt", "ndisp=8\n");
    write_pfm(*this / (folder + "/disp0GT.pfm"), cv::Mat1f(24, 40, static_cast<float>(kDisparity)));
  }
  Outcome bench(const std::string& arguments, const std::string& before = {}) const {
    return xgm::testing::pipeline(path(), "bench " + arguments, before);
  }
  /// Both pipelines on both scenes.
  Outcome both(const std::string& more = {}) const {
    return bench("--pipelines a.yaml,b.yaml --data trainingQ --threads 1 " + more);
  }
  std::string cell(const std::string& pipeline, const std::string& scene,
                   const std::string& file) const {
    return *this / ("xgm_bench/" + pipeline + "/trainingQ/" + scene + "/" + file);
  }
  nlohmann::json result() const {
    return nlohmann::json::parse(read_file(*this / "xgm_bench/bench.json"));
  }
};

void check_usage(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, message));
  CHECK_FALSE(contains(outcome.errors, " MB"));  // no run has been made
}

}  // namespace

TEST_CASE("two pipelines on two scenes give tables in four formats and ordinary results") {
  const Desk desk;
  const Outcome outcome = desk.both();
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "trainingQ: average of 2 scenes"));
  CHECK(contains(outcome.output, "total 0.5"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.md"), "| one | a |"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.csv"), "scene,trainingQ,two,b,done,"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.html"), "</html>"));
  const auto json = desk.result();
  REQUIRE(json["cells"].size() == 4);
  for (const auto& cell : json["cells"]) {
    CHECK(cell["state"] == "done");
    CHECK(cell["disparity_evaluations"] == 40 * 24 * 8);
    CHECK(cell["peak_memory_bytes"] > 1e6);
    CHECK(cell["truth"][0]["thresholds"][1]["bad"] < 0.05);
  }
  const auto run = nlohmann::json::parse(read_file(desk.cell("b", "two", "run.json")));
  CHECK(run["threads"] == 1);
  CHECK(read_pfm(desk.cell("b", "two", "disparity.pfm")).size() == cv::Size(40, 24));
}

TEST_CASE("started again, a bench runs what has changed only") {
  const Desk desk;
  REQUIRE(desk.both().exit_code == 0);
  Outcome again = desk.both();
  CHECK(again.exit_code == 0);
  CHECK_FALSE(contains(again.errors, " MB"));
  desk.write("b.yaml", "# a comment changes nothing\n" + flat_pipeline("6"));
  again = desk.both();
  CHECK_FALSE(contains(again.errors, "a on one: "));
  CHECK(contains(again.errors, "b on one: "));
  CHECK(contains(again.errors, "b on two: "));
  desk.add_scene("two", 7);
  again = desk.both("--thresholds 1,3 --scale 4 --clip --region all");
  CHECK(contains(again.errors, "a on two: "));
  CHECK_FALSE(contains(again.errors, "a on one: "));
  CHECK(contains(again.output, "total 3"));
}

TEST_CASE("a bench that is told to stop writes what it has, and goes on when started again") {
  const Desk desk;
  std::string points = "1";
  for (int p1 = 2; p1 <= 19; ++p1) points += "," + std::to_string(p1);
  const std::string arguments =
      "--pipelines a.yaml --data trainingQ --threads 1 --sweep matcher.matcher.penalty.p1=" +
      points;
  const std::string first = desk.cell("a+p1=1", "one", "cell.json");
  const std::string script = "sh -c '\"$@\" & child=$!; while [ ! -e \"" + first +
                             "\" ]; do sleep 0.02; done; kill -TERM $child; wait $child' sh ";
  const Outcome stopped = desk.bench(arguments, script);
  INFO(stopped.errors);
  CHECK(stopped.exit_code == 128 + 15);
  CHECK(contains(stopped.errors, "the same command goes on from here"));
  CHECK(contains(stopped.output, "are still to be done"));
  CHECK(desk.result()["interrupted"] == true);
  const auto before = fs::last_write_time(first);
  const Outcome resumed = desk.bench(arguments);
  CHECK(resumed.exit_code == 0);
  CHECK(fs::last_write_time(first) == before);
  CHECK(desk.result()["interrupted"] == false);
  CHECK(desk.result()["cells"].size() == 38);
}

TEST_CASE("a broken scene is a marked row, and the exit code tells") {
  const Desk desk;
  desk.write("trainingQ/two/im1.png", "no image at all");
  const Outcome outcome = desk.both();
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.output, "1 of 2"));
  CHECK(contains(outcome.output, "a failed on two: "));
  CHECK(contains(outcome.output, "im1.png"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.md"), "| two | b | failed |"));
  desk.add_scene("two", 6);
  CHECK(desk.both().exit_code == 0);
}

TEST_CASE("a scene whose name looks like an option is a scene") {
  const Desk desk;
  desk.add_scene("-three", 7);
  const Outcome outcome =
      desk.bench("--pipelines a.yaml --data trainingQ --threads 1 --scenes=-three");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(fs::exists(desk / "xgm_bench/a/trainingQ/-three/disparity.pfm"));
}

TEST_CASE("the page judges by the rules of this bench, not by those of the runs") {
  const Desk desk;
  REQUIRE(desk.both().exit_code == 0);
  CHECK_FALSE(contains(read_file(desk / "xgm_bench/bench.html"), "total &gt; 7.0 px"));
  REQUIRE(desk.both("--thresholds 7 --region all").exit_code == 0);
  const std::string page = read_file(desk / "xgm_bench/bench.html");
  CHECK(contains(page, "total &gt; 7.0 px"));
  CHECK_FALSE(contains(page, "total &gt; 0.5 px"));
}

TEST_CASE("two benches do not work in one folder at once") {
  const Desk desk;
  fs::create_directories(desk / "xgm_bench");
  {
    const FolderLock other(desk / "xgm_bench");
    check_usage(desk.both(), "another bench works in xgm_bench; wait for it or give another");
  }
  CHECK(desk.both().exit_code == 0);
}

TEST_CASE("no run outlives a bench that is killed") {
  const Desk desk;
  // The run is stopped before its bench is killed: it cannot have ended by itself.
  const std::string script =
      "timeout 60 sh -c '\"$@\" & bench=$!; "
      "until read -r run rest < /proc/$bench/task/$bench/children; "
      "grep -qs -e --scene /proc/$run/cmdline; do :; done; "
      "kill -STOP $run; kill -KILL $bench; wait $bench; sleep 0.2; "
      "! grep -qs \"State:.*[RSTD] \" /proc/$run/status' sh ";
  const Outcome outcome = desk.bench(
      "--pipelines a.yaml --data trainingQ --sweep matcher.matcher.penalty.p1=1,2,3,4,5,6,7,8,9",
      script);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("mistakes are told before any run") {
  const Desk desk;
  check_usage(desk.both("--output a.yaml/b"),
              "--output a.yaml/b: cannot be made a folder: Not a directory");
  check_usage(desk.bench("--pipelines 'a.yaml, nobody' --data trainingQ"), "'nobody'");
  check_usage(desk.bench("--pipelines a.yaml,nobody --data trainingQ"), "'nobody'");
  check_usage(desk.bench("--pipelines a.yaml --data nowhere"), "nowhere: no such folder");
  check_usage(desk.both("--scenes one,tow"), "did you mean 'two'");
  check_usage(desk.both("--sweep matcher.matcher.penalty.p1=4,-1"), "p1");
  check_usage(desk.both("--sweep matcher.scale=4,8"), "scale");
  check_usage(desk.both("--sweep matcher.scale"), "PATH=VALUE");
  check_usage(
      desk.both("--sweep matcher.matcher.penalty.p1=4 --sweep matcher.matcher.penalty.p1=5"),
      "is given twice");
  check_usage(desk.both("--scale half"), "above 0, or full");
  check_usage(desk.both("--thresholds 2,1"), "write rising numbers");
  check_usage(desk.both("--submit kitti"), "not called as KITTI's frames");
  check_usage(desk.both("--submit eth3d --method mine"), "one at a time");
  desk.write("trainingQ/two/calib.txt", "width=40\n");
  check_usage(desk.both("--clip --set 'disparities=[0, 7]'"),
              "nothing gives the ndisp of scene two");
  desk.write("trainingQ/one/calib.txt", "width=40\n");
  check_usage(desk.both(), "nothing says which disparities");
}

TEST_CASE("--submit writes the benchmark's folders") {
  const Desk desk;
  const Outcome outcome = desk.bench(
      "--pipelines a.yaml --data trainingQ --threads 1 --submit middlebury --method mine");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  const std::string scene = desk / "xgm_bench/submit/a/trainingQ/one/";
  CHECK(std::stod(read_file(scene + "timemine.txt")) >= 0);
  const bool dense = fs::exists(scene + "disp0mine.pfm");
  const cv::Mat1f map = read_pfm(scene + (dense ? "disp0mine.pfm" : "disp0mine_s.pfm"));
  CHECK(map.size() == cv::Size(40, 24));
  CHECK(contains(outcome.output, "zip -r ../a.zip"));
}
