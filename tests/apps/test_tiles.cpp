// SPDX-License-Identifier: Apache-2.0
// pipeline run --tiles, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using xgm::testing::check_usage_error;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;
using xgm::testing::write_tiff;

namespace {

struct Desk : TemporaryFolder {
  explicit Desk(cv::Size size, int disparities) {
    std::filesystem::create_directory(*this / "scene");
    testing::SceneOptions options;
    options.size = size;
    options.disparities = {0, disparities};
    const testing::SyntheticScene scene = testing::make_scene(options);
    write_png(*this / "scene/im0.png", picture(scene.pair.base));
    write_png(*this / "scene/im1.png", picture(scene.pair.match));
    write("scene/calib.txt", "ndisp=" + std::to_string(disparities) + "\n");
  }
  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return testing::pipeline(path(), "run " + arguments + " -o out", before);
  }
  std::vector<std::string> maps() const {
    std::vector<std::string> bytes;
    for (const char* name : kMapFiles)
      bytes.push_back(read_file(*this / "out" + ("/" + std::string(name))));
    return bytes;
  }
  nlohmann::json record() const { return nlohmann::json::parse(read_file(*this / "out/run.json")); }
};

/// Reports need all of the images and the map, which are then held; without one they are not.
void check_held_and_not(const Desk& desk, const std::string& arguments) {
  CAPTURE(arguments);
  const Outcome held = desk.run(arguments + " --report");
  INFO(held.errors);
  REQUIRE(held.exit_code == 0);
  const std::vector<std::string> maps = desk.maps();
  const nlohmann::json record = desk.record();
  const Outcome in_windows = desk.run(arguments);
  INFO(in_windows.errors);
  REQUIRE(in_windows.exit_code == 0);
  CHECK(desk.maps() == maps);
  for (const char* field : {"valid_share", "status_shares", "warnings", "scene", "disparities"}) {
    CAPTURE(field);
    CHECK(desk.record()[field] == record[field]);
  }
}

cv::Mat1b grey_of(const std::string& file) { return read_mask(file, MaskUse::objects).value; }

}  // namespace

TEST_CASE("run --tiles: the map and its record, each stage once") {
  const Desk desk({240, 160}, 32);
  const Outcome outcome = desk.run("tmgm16_refined scene --tiles 100x80 --report");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.errors, "matched in tiles of up to 100 x 80 px"));
  CHECK(read_map(desk / "out/disparity.pfm").value.density() == 1);
  CHECK(std::filesystem::exists(desk / "out/report.html"));
  std::vector<std::string> paths;
  const nlohmann::json record = desk.record();
  for (const auto& stage : record["stages"]) paths.push_back(stage["stage"]);
  std::sort(paths.begin(), paths.end());
  CHECK(std::adjacent_find(paths.begin(), paths.end()) == paths.end());
  CHECK(std::find(paths.begin(), paths.end(), "matcher.s1.matcher") != paths.end());
}

TEST_CASE("run --tiles: images and maps that are not held give the bytes of those that are") {
  const Desk desk({240, 160}, 32);
  check_held_and_not(desk, "tmgm16_refined scene --tiles 130x100");
  const cv::Mat1b left = grey_of(desk / "scene/im0.png"), right = grey_of(desk / "scene/im1.png");
  const auto write_pair = [&](int depth, double gain, const testing::TiffStyle& style) {
    for (const auto& [file, image] : {std::pair("left.tif", left), {"right.tif", right}}) {
      std::vector<cv::Mat> bands(1);
      image.convertTo(bands[0], depth, gain);
      write_tiff(desk / file, bands, style);
    }
  };
  const std::string files =
      "tsgm8 --left left.tif --right right.tif --disparities 0:15 --tiles 130x100";
  write_pair(CV_16U, 16, {.no_data = "80", .tiled = true});
  check_held_and_not(desk, files);
  write_pair(CV_8U, 1, {.compressed = true, .big = true});
  check_held_and_not(desk, files + " --nodata 12");
  cv::Mat1b mask(left.size(), std::uint8_t{255});
  mask(cv::Rect(80, 60, 50, 50)).setTo(0);
  write_png(desk / "mask.png", mask);
  check_held_and_not(desk, files + " --left-mask mask.png");
}

TEST_CASE("run --tiles: the confidence is joined, too, held or not") {
  const Desk desk({240, 160}, 32);
  const std::string arguments =
      "tsgm8 scene --tiles 130x100 --set matcher.matcher.matcher.confidence=peak_ratio";
  const std::string file = desk / "out/confidence.pfm";
  REQUIRE(desk.run(arguments + " --report").exit_code == 0);
  const std::string held = read_file(file);
  const cv::Mat1f sure = read_pfm(file), map = read_pfm(desk / "out/disparity.pfm");
  CHECK(cv::countNonZero((sure == sure) != (map == map)) == 0);  // where there is a disparity
  const Outcome in_windows = desk.run(arguments);
  REQUIRE(in_windows.exit_code == 0);
  CHECK(contains(in_windows.output, "out/confidence.pfm"));
  CHECK(read_file(file) == held);
  REQUIRE(desk.run("tsgm8 scene --tiles 130x100").exit_code == 0);
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("run --tiles: a scene's truth is compared, unless its images do not fit") {
  const Desk desk({240, 160}, 32);
  write_pfm(desk / "scene/disp0GT.pfm", cv::Mat1f(cv::Size(240, 160), 5.0F));
  REQUIRE(desk.run("sgm8 scene --tiles 100x80").exit_code == 0);
  CHECK(desk.record()["truth"].size() > 0);
}

TEST_CASE("run --tiles: files that are missing or damaged are one error that names them") {
  const Desk desk({240, 160}, 32);
  const cv::Mat1b left = grey_of(desk / "scene/im0.png");
  write_tiff(desk / "left.tif", {left}, {.tiled = true});
  write_png(desk / "left.png", left);
  for (const std::string ending : {"tif", "png"}) {
    const std::string bytes = read_file(desk / "left." + ending);
    desk.write("cut." + ending, bytes.substr(0, bytes.size() / 2));
    const Outcome outcome = desk.run("sgm8 --left left." + ending + " --right cut." + ending +
                                     " --disparities 0:9 --tiles 100x80");
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.errors, "cut." + ending + ": "));
    CHECK(outcome.errors.find("error:") == outcome.errors.rfind("error:"));
    CHECK_FALSE(std::filesystem::exists(desk / "out/run.json"));
  }
  check_usage_error(
      desk.run("sgm8 --left left.tif --right none.tif --disparities 0:9 --tiles auto"), "none.tif");
}

TEST_CASE("run --tiles: one that is ended at any moment leaves no file") {
  const Desk desk({700, 500}, 64);
  int ended = 0;
  for (const std::string how : {"-s INT ", "-s KILL "}) {
    for (const std::string after : {"0.15", "0.4", "0.8", "1.2"}) {
      std::filesystem::remove_all(desk / "out");
      desk.run("sgm8 scene --tiles 100x100 --log-level error", "timeout " + how + after + " ");
      if (std::filesystem::exists(desk / "out/run.json")) continue;  // it was quicker
      ++ended;
      for (const char* name : kMapFiles) {
        CHECK_FALSE(std::filesystem::exists(desk / "out" + ("/" + std::string(name))));
      }
    }
  }
  CHECK(ended > 0);
}

TEST_CASE("run --tiles: a disk that is too small for the map is one error, before matching") {
  const Desk desk({240, 160}, 32);
  write_tiff(desk / "left.tif", {grey_of(desk / "scene/im0.png")}, {});
  const Outcome outcome =
      desk.run("sgm8 --left left.tif --right left.tif --disparities 0:9 --tiles 100x80",
               "trap '' XFSZ; ulimit -f 100; ");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "disparity.pfm: cannot be written"));
  CHECK_FALSE(std::filesystem::exists(desk / "out/disparity.pfm"));
  CHECK_FALSE(contains(outcome.errors, "matching  "));
}

TEST_CASE("run --tiles: mistakes are exit 2, before any work") {
  const Desk desk({60, 40}, 8);
  for (const char* size : {"300", "0x0", "big", "300x", "x300", "-1x300", "63x64", "1e3x1e3"}) {
    check_usage_error(desk.run("tsgm8 scene --tiles=" + std::string(size)),
                      "write auto, or WIDTHxHEIGHT");
  }
  check_usage_error(desk.run("tsgm8 scene --tiles auto --dump '*'"),
                    "leave out --dump and --explain");
  check_usage_error(desk.run("tsgm8 scene --tiles auto --explain 1,1"),
                    "leave out --dump and --explain");
  CHECK_FALSE(std::filesystem::exists(desk / "out/run.json"));
}

#ifndef XGM_SANITIZED  // sanitizers need memory of their own
TEST_CASE("run: the memory limit is kept, by tiles that fit or by a refusal") {
  const Desk desk({1400, 1000}, 128);
  const std::string limit = " --memory-limit 350MB";
  for (const std::string tiles : {" --tiles auto", " --report"}) {
    CAPTURE(tiles);
    const Outcome tiled = desk.run("sgm8 scene" + tiles + limit);
    INFO(tiled.errors);
    REQUIRE(tiled.exit_code == 0);
    CHECK(contains(tiled.errors, "matched in tiles of up to"));
    CHECK(contains(tiled.errors, "the whole takes") == (tiles != " --tiles auto"));
    CHECK(desk.record()["peak_memory_bytes"] < 350e6);
  }
  const Outcome whole = desk.run("sgm8 scene --memory-limit 2GB");
  REQUIRE(whole.exit_code == 0);
  CHECK_FALSE(contains(whole.errors, "in tiles"));
  const std::vector<std::string> maps = desk.maps();
  REQUIRE(desk.run("sgm8 scene").exit_code == 0);
  CHECK(desk.maps() == maps);
  check_usage_error(desk.run("sgm8 scene --tiles 1400x1000" + limit), "give smaller ones");
  check_usage_error(desk.run("sgm8 scene --tiles auto --memory-limit 60MB"),
                    "raise --memory-limit");
  check_usage_error(desk.run("sgm8 scene --dump '*'" + limit),
                    "match in tiles (pipeline run --tiles auto)");
}

TEST_CASE("run: images that take far more than the memory limit are matched within it") {
  const Desk desk({60, 40}, 8);
  constexpr int kWidth = 8000, kHeight = 6000,
                kShift = 2;  // as floats: 384 MB, and 240 for the map
  cv::Mat1b scene(kHeight, kWidth + kShift);
  cv::theRNG().state = 1;
  cv::randu(scene, 0, 256);
  write_tiff(desk / "left.tif", {scene.colRange(0, kWidth).clone()}, {});
  write_tiff(desk / "right.tif", {scene.colRange(kShift, kWidth + kShift).clone()}, {});
  desk.write("quick.yaml",
             "matcher: {type: semi_global, cost: absolute_difference, penalty: {type: constant, "
             "p1: 8, p2: 32}, aggregation: {type: sgm, directions: 4}}\n");
  const Outcome outcome = desk.run(
      "quick.yaml --left left.tif --right right.tif --disparities 0:3 --memory-limit 250MB");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  MESSAGE("peak: " << desk.record()["peak_memory_bytes"].get<double>() / 1e6 << " MB");
  CHECK(desk.record()["peak_memory_bytes"] < 250e6);
  CHECK(desk.record()["status_shares"]["valid"] > 0.99);
}
#endif
