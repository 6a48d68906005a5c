// SPDX-License-Identifier: Apache-2.0
// pipeline run --tiles, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

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
  Outcome run(const std::string& arguments) const {
    return testing::pipeline(path(), "run " + arguments + " -o out");
  }
  nlohmann::json record() const { return nlohmann::json::parse(read_file(*this / "out/run.json")); }
};

void check_usage(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, message));
}

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
  for (const auto& stage : desk.record()["stages"]) paths.push_back(stage["stage"]);
  std::sort(paths.begin(), paths.end());
  CHECK(std::adjacent_find(paths.begin(), paths.end()) == paths.end());
  CHECK(std::find(paths.begin(), paths.end(), "matcher.s1.matcher") != paths.end());
}

TEST_CASE("run --tiles: mistakes are exit 2, before any work") {
  const Desk desk({60, 40}, 8);
  for (const char* size : {"300", "0x0", "big", "300x", "x300", "-1x300", "63x64", "1e3x1e3"}) {
    check_usage(desk.run("tsgm8 scene --tiles=" + std::string(size)),
                "write auto, or WIDTHxHEIGHT");
  }
  check_usage(desk.run("tsgm8 scene --tiles auto --dump '*'"), "leave out --dump and --explain");
  check_usage(desk.run("tsgm8 scene --tiles auto --explain 1,1"), "leave out --dump and --explain");
  CHECK_FALSE(std::filesystem::exists(desk / "out/run.json"));
}

#ifndef XGM_SANITIZED  // sanitizers need memory of their own
TEST_CASE("run --tiles: the memory limit is kept, by tiles that fit or by a refusal") {
  const Desk desk({1400, 1000}, 128);
  const std::string limit = " --log-level error --memory-limit 350MB";
  const Outcome whole = desk.run("sgm8 scene" + limit);
  check_usage(whole, "match in tiles (pipeline run --tiles auto)");
  const Outcome tiled = desk.run("sgm8 scene --tiles auto" + limit);
  INFO(tiled.errors);
  REQUIRE(tiled.exit_code == 0);
  CHECK(desk.record()["peak_memory_bytes"] < 1.05 * 350e6);
  check_usage(desk.run("sgm8 scene --tiles 1400x1000" + limit), "give smaller ones");
  check_usage(desk.run("sgm8 scene --tiles auto --memory-limit 60MB"), "raise --memory-limit");
}
#endif
