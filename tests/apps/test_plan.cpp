// SPDX-License-Identifier: Apache-2.0
// pipeline plan and --memory-limit, as a user meets them.
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

/// A generated scene large enough that volumes outweigh the program.
struct Desk : TemporaryFolder {
  Desk() {
    std::filesystem::create_directory(*this / "scene");
    testing::SceneOptions options;
    options.size = {900, 700};
    options.disparities = {0, 112};
    options.colour = true;
    const testing::SyntheticScene scene = testing::make_scene(options);
    write_png(*this / "scene/im0.png", picture(scene.pair.base));
    write_png(*this / "scene/im1.png", picture(scene.pair.match));
    write("scene/calib.txt", "ndisp=112\n");
  }
  Outcome call(const std::string& arguments) const { return testing::pipeline(path(), arguments); }
  nlohmann::json plan(const std::string& arguments) const {
    const Outcome outcome = call("plan " + arguments + " --json --log-level warning");
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(outcome.output);
  }
  double measured_peak(const std::string& arguments) const {
    const Outcome outcome = call("run " + arguments + " -o out --log-level error");
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(read_file(*this / "out/run.json"))["peak_memory_bytes"];
  }
};

void check_usage(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, message));
  CHECK(outcome.errors.find("error:") == outcome.errors.rfind("error:"));
}

}  // namespace

// Sanitizers need memory of their own.
#ifndef XGM_SANITIZED
TEST_CASE("plan: the peak of a run is within 15 % of the plan, dense and in a pyramid") {
  const Desk desk;
  for (const std::string name : {"sgm8", "mgm16", "tsgm8", "tmgm16_refined"}) {
    CAPTURE(name);
    const std::string arguments = name + " scene --threads 2";
    const double measured = desk.measured_peak(arguments);
    const double planned = desk.plan(arguments)["peak_memory_bytes"];
    MESSAGE(name, ": planned ", planned / 1e6, " MB, measured ", measured / 1e6, " MB");
    CHECK(planned > 0.87 * measured);
    CHECK(planned < 1.15 * measured);
  }
}
#endif

TEST_CASE("plan: the table tells levels and views, peak and time; --stages every stage") {
  const Desk desk;
  const Outcome outcome = desk.call("plan tsgm8 --size 640x480 --disparities 0:63");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "640 x 480 px, 64 disparities (0 to 63)"));
  CHECK(contains(outcome.output, "matcher.s1.matcher.reverse.matcher "));
  CHECK(contains(outcome.output, "memory: "));
  CHECK(contains(outcome.output, "time: "));
  CHECK_FALSE(contains(outcome.output, ".cost"));
  CHECK(contains(desk.call("plan tsgm8 --size 64x48 --disparities 0:15 --stages").output, ".cost"));
}

TEST_CASE("plan: --set, the pipeline's own disparities and one thread are heeded") {
  const Desk desk;
  const auto plan = desk.plan(
      "tsgm8 --size 320x240 --set matcher.scale=2 --set 'disparities=[-8, 23]' --threads 1");
  CHECK(plan["disparities"]["first"] == -8);
  CHECK(plan["threads"] == 1);
  for (const auto& stage : plan["stages"]) CHECK_FALSE(contains(stage["stage"], ".s4"));
}

TEST_CASE("plan: mistakes are exit 2") {
  const Desk desk;
  check_usage(desk.call("plan"), "pipeline is required");
  check_usage(desk.call("plan sgm8 --size 640"), "WIDTHxHEIGHT");
  check_usage(desk.call("plan sgm8 --size 640x0 --disparities 0:9"), "WIDTHxHEIGHT");
  check_usage(desk.call("plan sgm8 --size 640x480"), "--disparities MIN:MAX");
  check_usage(desk.call("plan sgm8 --size 64x48 --disparities 100:120"), "cannot be seen");
  check_usage(desk.call("plan sgm8 scene --size 64x48"), "--size");
  check_usage(desk.call("plan sgm8 --size 64x48 --range-maps a.pfm,b.pfm"), "--size");
  check_usage(desk.call("plan sgm8 nowhere"), "no such folder");
}

TEST_CASE("run: --memory-limit refuses before any work, and says what to change") {
  const Desk desk;
  // Tiles do not help where the results of stages are kept.
  const Outcome dense = desk.call("run sgm8 scene --dump '*' --memory-limit 150MB");
  check_usage(dense, "--memory-limit allows 150 MB");
  CHECK(contains(dense.errors, "search at most "));
  CHECK(contains(dense.errors, "take a pyramid pipeline"));
  CHECK_FALSE(std::filesystem::exists(desk / "xgm_output/run.json"));
  const Outcome pyramid = desk.call("run tsgm8 scene --memory-limit 80MB");
  check_usage(pyramid, "--memory-limit allows 80 MB");
  CHECK_FALSE(contains(pyramid.errors, "take a pyramid pipeline"));
  check_usage(desk.call("run sgm8 scene --memory-limit lots"), "800MB, 2.5GB");
  check_usage(desk.call("run sgm8 scene --memory-limit 0GB"), "800MB, 2.5GB");
  check_usage(desk.call("run sgm8 scene --memory-limit 800"), "800MB, 2.5GB");
  check_usage(desk.call("run sgm8 scene --memory-limit 1e308TB"), "800MB, 2.5GB");
  check_usage(desk.call("bench --pipelines sgm8 --data scene --memory-limit 5apples"),
              "800MB, 2.5GB");
  check_usage(desk.call("explain sgm8 scene 10 10 --memory-limit 150MB"), "search at most ");
  const Outcome nothing = desk.call("run sgm8 scene --memory-limit 1MB");
  check_usage(nothing, "raise --memory-limit, search fewer disparities");
  for (const char* size : {"1.5GB", "2G", "2gb", "'800 MiB'", "1g"}) {
    CAPTURE(size);
    CHECK(desk.call(std::string("run tsgm8 scene --log-level error --memory-limit ") + size)
              .exit_code == 0);
  }
}

TEST_CASE("bench: a run above --memory-limit is a failed cell with the reason") {
  const Desk desk;
  const Outcome outcome =
      desk.call("bench --pipelines sgm8,tsgm8 --data scene --memory-limit 200MB");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "--memory-limit allows 200 MB"));
}
