// SPDX-License-Identifier: Apache-2.0
// No command replaces a file that it reads. That `run` tells all kinds of inputs and all names of
// one file is tested in the framework; here is what the program adds to them.
#include <doctest/doctest.h>

#include "apps/small_scene.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SmallScene;

namespace fs = std::filesystem;

namespace {

/// `file` is the input that the message shall name; it is as before afterwards.
void check_refused(const SmallScene& desk, const std::string& arguments, const std::string& option,
                   const std::string& input) {
  CAPTURE(arguments);
  const std::string before = read_file(desk / input);
  const Outcome outcome = desk.call(arguments);
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.output.empty());
  CHECK(contains(outcome.errors, "error: " + option + ": "));
  CHECK(contains(outcome.errors, "is an input, which would be lost"));
  CHECK(contains(outcome.errors, input));
  CHECK(read_file(desk / input) == before);
}

}  // namespace

TEST_CASE("run: the truth, the pipeline and what describes the scene are kept") {
  const SmallScene desk;
  fs::rename(desk / "scene/disp0GT.pfm", desk / "scene/disparity.pfm");
  desk.write("scene/dataset.yaml",
             "type: folder\nleft: im0.png\nright: im1.png\ntruth: disparity.pfm\n");
  check_refused(desk, "run p.yaml scene --output scene", "--output", "scene/disparity.pfm");
  fs::create_directory(desk / "out");
  fs::create_hard_link(desk / "scene/dataset.yaml", desk / "out/status.png");
  check_refused(desk, "run p.yaml scene --output out", "--output", "scene/dataset.yaml");
  fs::rename(desk / "out/status.png", desk / "own.yaml");
  fs::create_symlink("../own.yaml", desk / "out/run.json");
  check_refused(desk, "run p.yaml scene --dataset own.yaml --output out", "--output", "own.yaml");
  fs::remove(desk / "out/run.json");
  fs::remove(desk / "scene/dataset.yaml");  // without it, the cameras are known
  fs::create_symlink("p.yaml", desk / "x.tiff");
  check_refused(desk, "run p.yaml scene --depth x.tiff", "--depth", "p.yaml");
  desk.write("plugin.so", "no plugin");
  fs::create_hard_link(desk / "plugin.so", desk / "x.ply");
  check_refused(desk, "run p.yaml scene --plugin plugin.so --cloud ./x.ply", "--cloud",
                "plugin.so");
}

TEST_CASE("eval: neither --json nor --csv replaces what is compared, or the other") {
  const SmallScene desk;
  REQUIRE(desk.call("run p.yaml scene --output out").exit_code == 0);
  write_pfm(desk / "sure.pfm", cv::Mat1f(24, 40, 1.0f));
  const std::string truth = "eval out --truth scene/disp0GT.pfm ";
  check_refused(desk, truth + "--json out/../out/disparity.pfm", "--json", "out/disparity.pfm");
  check_refused(desk, truth + "--csv out/run.json", "--csv", "out/run.json");
  check_refused(desk, truth + "--json scene/disp0GT.pfm", "--json", "scene/disp0GT.pfm");
  check_refused(desk, truth + "--confidence sure.pfm --csv sure.pfm", "--csv", "sure.pfm");
  check_refused(desk, "eval out scene --json scene/calib.txt", "--json", "scene/calib.txt");
  const Outcome twice = desk.call(truth + "--json a --csv ./a");
  CHECK(twice.exit_code == 2);
  CHECK(contains(twice.errors, "--csv: ./a is written for --json (a), too"));
}

TEST_CASE("explain, speed: --json replaces no input") {
  const SmallScene desk;
  check_refused(desk, "explain p.yaml scene 9 9 --json scene/im0.png", "--json", "scene/im0.png");
  check_refused(desk, "explain p.yaml scene 9 9 --json p.yaml", "--json", "p.yaml");
  check_refused(desk, "speed p.yaml scene --opencv none --json scene/im1.png", "--json",
                "scene/im1.png");
}

TEST_CASE("bench: neither its tables nor the files of its runs replace an input") {
  const SmallScene desk;
  const std::string arguments = "bench --pipelines p.yaml --data scene --output out";
  const fs::path cell = desk / "out/p" / fs::path(desk.path()).filename() / "scene";
  fs::create_directories(cell);
  for (const char* file : {"scene/im0.png", "scene/disp0GT.pfm", "p.yaml"}) {
    for (const fs::path& output : {fs::path(desk / "out/bench.md"), cell / "log.txt",
                                   cell / "disparity.pfm", cell / "run.json"}) {
      fs::create_symlink(desk / file, output);
      check_refused(desk, arguments, "--output", file);
      fs::remove(output);
    }
  }
}

TEST_CASE("run: --cloud and --depth may lie in a folder that --output makes") {
  for (const char* arguments :
       {"--output results --cloud results/points.ply", "--output a/b/c --cloud a/b/points.ply",
        "--output ./a/b --cloud a/../a/b/points.ply --depth a/z.tiff"}) {
    CAPTURE(arguments);
    const SmallScene desk;
    const Outcome outcome = desk.call("run p.yaml scene " + std::string(arguments));
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 0);
    const std::string cloud =
        std::string(arguments).substr(std::string(arguments).find("--cl") + 8);
    CHECK(fs::file_size(desk / cloud.substr(0, cloud.find(' '))) > 1000);
  }
  const SmallScene desk;
  const Outcome lost = desk.call("run p.yaml scene --output results --cloud results/b/points.ply");
  CHECK(lost.exit_code == 2);
  CHECK(contains(lost.errors, "there is no folder results/b; make it first"));
  CHECK_FALSE(fs::exists(desk / "results"));
}
