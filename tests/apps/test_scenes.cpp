// SPDX-License-Identifier: Apache-2.0
// pipeline scenes; and what pipeline run makes of a scene's name, truth and cameras.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

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

/// Two scenes 3 px deep: "full" with truth and cameras, "bare" without.
struct Desk : TemporaryFolder {
  Desk() {
    const ImagePair pair = xgm::testing::shifted_pair({40, 24}, 3, 5);
    for (const std::string scene : {"data/full", "data/bare"}) {
      std::filesystem::create_directories(*this / scene);
      write_png(*this / (scene + "/im0.png"), picture(pair.base));
      write_png(*this / (scene + "/im1.png"), picture(pair.match));
    }
    write_pfm(*this / "data/full/disp0GT.pfm", cv::Mat1f(24, 40, 3.0f));
    write("data/full/calib.txt",
          "cam0=[100 0 20; 0 100 12; 0 0 1]\ndoffs=1\nbaseline=50\nndisp=8\n");
    write("data/bare/calib.txt", "ndisp=8\n");
  }
  Outcome call(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), arguments);
  }
};

}  // namespace

TEST_CASE("scenes: a table with what is missing, and JSON") {
  const Desk desk;
  const Outcome table = desk.call("scenes data");
  INFO(table.errors);
  CHECK(table.exit_code == 0);
  CHECK(contains(table.output, "2 scenes of data set middlebury_v3"));
  CHECK(contains(table.output, "0:7"));
  CHECK(contains(table.output, "disp0GT.pfm (2014 set: disp0.pfm): true disparities to judge by"));
  CHECK(contains(table.output, "    in bare\n"));
  const auto json = nlohmann::json::parse(desk.call("scenes data --json").output);
  CHECK(json[1]["name"] == "full");
  CHECK(json[1]["calibration"]["doffs_px"] == 1);
  std::filesystem::rename(desk / "data/bare", desk / "data/caf\xe9");  // no UTF-8
  CHECK(nlohmann::json::parse(desk.call("scenes data --json").output).size() == 2);
  const Outcome none = desk.call("scenes .");
  CHECK(none.exit_code == 2);
  CHECK(contains(none.errors, "is no scene and holds none"));
}

TEST_CASE("run: --scene chooses, and a miss is a usage error before anything is written") {
  const Desk desk;
  const Outcome which = desk.call("run sgm8 data");
  CHECK(which.exit_code == 2);
  CHECK(contains(which.errors, "choose one with --scene NAME: bare, full"));
  const Outcome miss = desk.call("run sgm8 data --scene ful");
  CHECK(miss.exit_code == 2);
  CHECK(contains(miss.errors, "did you mean 'full'?"));
  CHECK(desk.call("run sgm8 data --scene full --dataset kitti").exit_code == 2);
  CHECK(desk.call("run sgm8 --scene full").exit_code == 2);
  CHECK_FALSE(std::filesystem::exists(desk / "xgm_output"));
}

TEST_CASE("run: the scene's own truth judges; truth of no use is warned of and stops nothing") {
  const Desk desk;
  const Outcome full = desk.call("run sgm8 data --scene full");
  INFO(full.errors);
  CHECK(full.exit_code == 0);
  CHECK(contains(full.output, "truth:   all"));
  const auto record = nlohmann::json::parse(read_file(desk / "xgm_output/run.json"));
  CHECK(record["scene"]["name"] == "full");
  CHECK(record["truth"][0]["region"] == "all");
  CHECK(record["scene"]["inputs"][3]["role"] == "truth");
  CHECK_FALSE(contains(desk.call("run sgm8 data/bare").output, "truth:"));
  write_pfm(desk / "data/full/disp0GT.pfm", cv::Mat1f(24, 41, 3.0f));
  const Outcome wrong = desk.call("run sgm8 data/full");
  CHECK(wrong.exit_code == 0);
  CHECK(contains(wrong.errors, "the scene's truth is not used: "));
}

TEST_CASE("run: --cloud and --depth, in mm") {
  const Desk desk;
  const Outcome outcome = desk.call("run sgm8 data/full --cloud out.ply");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(read_file(desk / "out.ply").starts_with("ply\nformat binary_little_endian 1.0\n"));
  const cv::Mat depth = cv::imread(desk / "out_depth.tiff", cv::IMREAD_UNCHANGED);
  REQUIRE(depth.type() == CV_32FC1);
  CHECK(depth.at<float>(12, 20) == 1250);  // 50 mm * 100 px / (3 + 1) px
  CHECK(desk.call("run sgm8 data/full --depth z.tiff").exit_code == 0);
  CHECK(std::filesystem::exists(desk / "z.tiff"));
}

TEST_CASE("run: a cloud without cameras, or to where nothing can be written, is a usage error") {
  const Desk desk;
  const auto check = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = desk.call("run sgm8 " + arguments);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, message));
  };
  check("data/bare --cloud a.ply", "--cloud: the cameras are not known");
  check("--depth a.tiff", "--depth: the cameras are not known");
  check("data/full --cloud nowhere/a.ply", "there is no folder nowhere");
  std::filesystem::create_directory(desk / "a.ply");
  check("data/full --cloud a.ply", "is a folder");
  check("data/full --cloud disparity.pfm", "the name must end in .ply");
  check("data/full --depth d.png", "the name must end in .tiff");
  check("data/full --cloud b.ply --depth b.ply", "the name must end in .tiff");
  std::filesystem::remove(desk / "data/bare/im1.png");
  check("data --scene bare", "scene bare cannot be matched: ");
  CHECK_FALSE(std::filesystem::exists(desk / "xgm_output"));
}
