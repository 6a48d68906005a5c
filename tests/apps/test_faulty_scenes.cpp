// SPDX-License-Identifier: Apache-2.0
// A scene that is broken stops no other: pipeline scenes, run, bench and eval beside one.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
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

const std::string kCameras = "cam0=[100 0 20; 0 100 12; 0 0 1]\ndoffs=1\nbaseline=50\n";

/// Scenes "good" and "bad", 3 px deep; the calib.txt of "bad" is as told.
struct Desk : TemporaryFolder {
  explicit Desk(const std::string& bad_calib) {
    const ImagePair pair = xgm::testing::shifted_pair({40, 24}, 3, 5);
    for (const std::string scene : {"data/good", "data/bad"}) {
      fs::create_directories(*this / scene);
      write_png(*this / (scene + "/im0.png"), picture(pair.base));
      write_png(*this / (scene + "/im1.png"), picture(pair.match));
      write_pfm(*this / (scene + "/disp0GT.pfm"), cv::Mat1f(24, 40, 3.0F));
    }
    write("data/good/calib.txt", kCameras + "width=40\nheight=24\nndisp=8\n");
    write("data/bad/calib.txt", bad_calib);
  }
  Outcome call(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), arguments + " --threads 1");
  }
  Outcome scenes(const std::string& arguments = {}) const {
    return xgm::testing::pipeline(path(), "scenes data " + arguments);
  }
};

void check_others_work(const Desk& desk, const std::string& message) {
  const Outcome listed = desk.scenes();
  INFO(listed.errors);
  CHECK(listed.exit_code == 0);
  CHECK(contains(listed.output, "2 scenes of data set"));
  CHECK(contains(listed.output, message));
  CHECK(contains(desk.scenes("--json").output, message));
  const Outcome run = desk.call("run sgm8 data --scene good --depth z.tiff");
  CHECK(run.exit_code == 0);
  CHECK_FALSE(contains(run.errors, message));
  const Outcome bench = desk.call("bench --pipelines sgm8 --data data");
  INFO(bench.errors);
  CHECK(bench.exit_code == 1);
  CHECK(contains(bench.output, "sgm8 failed on bad: "));
  CHECK(contains(bench.output, message));
  CHECK(contains(read_file(desk / "xgm_bench/bench.md"), "| bad | sgm8 | failed |"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.csv"), "scene,data,good,sgm8,done,"));
  const std::string judged = "xgm_bench/sgm8/data/good";
  CHECK(xgm::testing::pipeline(desk.path(), "eval " + judged + " data --scene good").exit_code ==
        0);
}

}  // namespace

TEST_CASE("a calib.txt that cannot be parsed is its own scene's fault") {
  const Desk desk(kCameras + "ndisp=many\n");
  check_others_work(desk, "data/bad/calib.txt:4: ndisp is");
  const auto json = nlohmann::json::parse(desk.scenes("--json").output);
  CHECK(json[0]["name"] == "bad");
  CHECK(json[0]["faults"][0]["file"] == "data/bad/calib.txt");
  CHECK(json[1]["faults"].empty());
  const Outcome refused = desk.call("run sgm8 data --scene bad");
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "calib.txt:4: ndisp is"));
  const Outcome told = desk.call("run sgm8 data --scene bad --disparities 0:7");
  CHECK(told.exit_code == 0);
  CHECK(contains(told.errors, "the calibration is not used: data/bad/calib.txt:4"));
  CHECK(contains(read_file(desk / "xgm_output/run.json"), "the calibration is not used: "));
}

TEST_CASE("a calibration of another size stops its own scene, and depths of it") {
  const Desk desk(kCameras + "width=80\nheight=48\nndisp=16\n");
  const std::string message = "is about images of 80 x 48 pixels but these are 40 x 24";
  const Outcome run = desk.call("run sgm8 data --scene bad");
  CHECK(run.exit_code == 1);
  CHECK(contains(run.errors, message));
  CHECK_FALSE(fs::exists(desk / "xgm_output/run.json"));
  const Outcome depth = desk.call("run sgm8 data --scene bad --disparities 0:7 --depth z.tiff");
  CHECK(depth.exit_code == 1);
  CHECK(contains(depth.errors, message));
  CHECK_FALSE(fs::exists(desk / "z.tiff"));
  const Outcome map = desk.call("run sgm8 data --scene bad --disparities 0:7");
  CHECK(map.exit_code == 0);
  CHECK(contains(map.errors, message));
  const Outcome clipped =
      xgm::testing::pipeline(desk.path(), "eval xgm_output data --scene bad --clip ndisp");
  CHECK(clipped.exit_code == 2);
  CHECK(contains(clipped.errors, message));
  const Outcome bench = desk.call("bench --pipelines sgm8 --data data");
  CHECK(bench.exit_code == 1);
  CHECK(contains(bench.output, message));
}

TEST_CASE("an image that leads nowhere or is empty is its own scene's fault") {
  const Desk desk("ndisp=8\n");
  fs::remove(desk / "data/bad/im1.png");
  fs::create_symlink(desk / "nowhere.png", desk / "data/bad/im1.png");
  check_others_work(desk, "data/bad/im1.png: is a link that leads nowhere");
  fs::remove(desk / "data/bad/im1.png");
  desk.write("data/bad/im1.png", "");
  check_others_work(desk, "data/bad/im1.png: is empty");
}

TEST_CASE("an empty truth is its own scene's fault: a run goes on without, a bench fails there") {
  const Desk desk("ndisp=8\n");
  desk.write("data/bad/disp0GT.pfm", "");
  check_others_work(desk, "data/bad/disp0GT.pfm: is empty");
  CHECK(desk.call("run sgm8 data --scene bad").exit_code == 0);
}

TEST_CASE("a scene without ndisp fails in a bench, and the others are run") {
  const Desk desk("isint=0\n");
  const Outcome bench = desk.call("bench --pipelines sgm8 --data data");
  CHECK(bench.exit_code == 1);
  CHECK(contains(bench.output, "sgm8 failed on bad: nothing says which disparities to search"));
  CHECK(contains(read_file(desk / "xgm_bench/bench.csv"), "scene,data,good,sgm8,done,"));
}

TEST_CASE("eval names a truth of the other sign") {
  const Desk desk("ndisp=8\n");
  REQUIRE(desk.call("run sgm8 data --scene good").exit_code == 0);
  write_pfm(desk / "data/good/disp0GT.pfm", cv::Mat1f(24, 40, -3.0F));
  const Outcome outcome = xgm::testing::pipeline(desk.path(), "eval xgm_output data --scene good");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.errors, "have the other sign"));
  const Outcome run = desk.call("run sgm8 data --scene good");
  CHECK(contains(run.errors, "have the other sign"));
}
