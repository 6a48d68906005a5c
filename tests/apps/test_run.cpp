// SPDX-License-Identifier: Apache-2.0
// pipeline run, as a user meets it.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::check_usage_error;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

constexpr int kDisparity = 3;

/// A flat pipeline, a scene whose disparity is kDisparity everywhere, and no more.
struct Desk : TemporaryFolder {
  Desk() {
    write("p.yaml",
          "xgm: 1\n"
          "matcher:\n"
          "  type: left_right\n"
          "  consistency: lrrl\n"
          "  matcher:\n"
          "    type: semi_global\n"
          "    cost: {type: census, window: 5}\n"
          "    penalty: {type: constant, p1: 4, p2: 20}\n"
          "    aggregation: {type: sgm, directions: 4}\n");
    std::filesystem::create_directory(*this / "scene");
    const ImagePair pair = xgm::testing::shifted_pair({40, 24}, kDisparity, 5);
    write_png(*this / "scene/im0.png", picture(pair.base));
    write_png(*this / "scene/im1.png", picture(pair.match));
    write("scene/calib.txt", "ndisp=8\n");
    write_pfm(*this / "truth.pfm", cv::Mat1f(24, 40, static_cast<float>(kDisparity)));
  }
  Outcome run(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), "run " + arguments);
  }
  nlohmann::json record(const std::string& output = "xgm_output") const {
    return nlohmann::json::parse(read_file(*this / (output + "/run.json")));
  }
};

}  // namespace

TEST_CASE("run: a scene gives the right map, pictures and a record") {
  const Desk desk;
  const Outcome outcome = desk.run("p.yaml scene --output out --truth truth.pfm --threads 1");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "within 1 px"));
  const cv::Mat1f map = read_pfm(desk / "out/disparity.pfm");
  CHECK(map(12, 20) == kDisparity);
  CHECK_NOTHROW(read_mask(desk / "out/disparity.png", MaskUse::usable));
  CHECK_NOTHROW(read_mask(desk / "out/status.png", MaskUse::usable));
  const auto record = desk.record("out");
  CHECK(record["disparities"]["last"] == 7);
  CHECK(contains(record["disparities"]["from"], "calib.txt"));
  CHECK(record["threads"] == 1);
  CHECK(record["scene"]["inputs"].size() == 4);
  CHECK(record["valid_share"] > 0.7);
  CHECK(record["truth"][0]["invalid"] < 0.3);
  CHECK(record["truth"][0]["thresholds"].size() == 4);
  CHECK(record["stages"].size() >= 5);
  CHECK(record["peak_memory_bytes"] > 1000000);
  CHECK(record["command_line"][0] == "run");
}

TEST_CASE("run: disparities of the command line go before calib.txt, that before the pipeline") {
  const Desk desk;
  const auto from = [&](const std::string& arguments) {
    const Outcome outcome = desk.run("p.yaml " + arguments + " --log-level error");
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return desk.record()["disparities"];
  };
  const std::string set = " --set 'disparities=[1, 6]'";
  CHECK(from("scene --disparities -4:9" + set)["first"] == -4);
  CHECK(desk.record()["disparities"]["last"] == 9);
  CHECK(from("scene --disparities=-4:9")["from"] == "command line");
  CHECK(from("scene" + set)["last"] == 7);
  CHECK(from("--left scene/im0.png --right scene/im1.png" + set)["from"] == "pipeline");
  CHECK(desk.record()["disparities"]["last"] == 6);
  CHECK(desk.record()["pipeline"]["overrides"][0]["path"] == "disparities");
}

TEST_CASE("run: range maps, masks and --dump") {
  const Desk desk;
  write_pfm(desk / "min.pfm", cv::Mat1f(24, 40, 2.0f));
  write_pfm(desk / "max.pfm", cv::Mat1f(24, 40, 4.0f));
  cv::Mat1b mask(24, 40, 255);
  mask(12, 20) = 0;
  write_png(desk / "mask.png", mask);
  const Outcome outcome =
      desk.run("p.yaml scene --range-maps min.pfm,max.pfm --left-mask mask.png --dump '*' -o out");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(std::isnan(read_pfm(desk / "out/disparity.pfm")(12, 20)));
  CHECK(read_pfm(desk / "out/disparity.pfm")(12, 21) == kDisparity);
  const auto record = desk.record("out");
  CHECK(record["disparities"]["from"] == "range maps");
  CHECK(record["scene"]["inputs"].size() == 6);
  CHECK(record["dumps"].size() >= 4);
  for (const auto& dump : record["dumps"]) {
    CHECK(std::filesystem::file_size(desk / dump["file"].get<std::string>()) > 0);
  }
}

TEST_CASE("run: mistakes of usage are exit 2, before anything is written") {
  const Desk desk;
  check_usage_error(desk.run(""), "pipeline is required");
  check_usage_error(desk.run("tmgm61 scene"), "did you mean 'tmgm16.yaml'?");
  check_usage_error(desk.run("scene p.yaml"), "the pipeline comes first");
  check_usage_error(desk.run("p.yaml nowhere"), "no such folder");
  check_usage_error(desk.run("p.yaml p.yaml"), "is a file");
  check_usage_error(desk.run("p.yaml --left scene/im0.png"), "--right");
  check_usage_error(desk.run("p.yaml scene --left scene/im0.png --right scene/im1.png"), "--left");
  check_usage_error(desk.run("p.yaml --left no.png --right scene/im1.png"), "no.png");
  check_usage_error(desk.run("p.yaml --left scene/im0.png --right scene/im1.png"),
                    "--disparities MIN:MAX");
  check_usage_error(desk.run("p.yaml scene --disparities 5"), "MIN:MAX");
  check_usage_error(desk.run("p.yaml scene --disparities 0:x"), "MIN:MAX");
  check_usage_error(desk.run("p.yaml scene --disparities 0:99999999999"), "MIN:MAX");
  check_usage_error(desk.run("p.yaml scene --disparities 9:0"), "did you mean 0:9?");
  check_usage_error(desk.run("p.yaml scene --range-maps truth.pfm"), "MIN.pfm,MAX.pfm");
  check_usage_error(desk.run("p.yaml scene --range-maps truth.pfm,no.pfm"), "no.pfm");
  check_usage_error(desk.run("p.yaml scene --set matcher"), "PATH=VALUE");
  check_usage_error(desk.run("p.yaml scene --threads 0"), "--threads");
  check_usage_error(desk.run("p.yaml scene --log-level loud"), "--log-level");
  check_usage_error(desk.run("p.yaml scene --truth-scale 4"), "--truth");
  check_usage_error(desk.run("p.yaml scene --frobnicate"), "frobnicate");
  check_usage_error(desk.run("p.yaml scene --output p.yaml/out"), "--output");
  CHECK_FALSE(std::filesystem::exists(desk / "xgm_output"));
}

TEST_CASE("run: a faulty pipeline is exit 2 with its place, and no image is opened") {
  const Desk desk;
  desk.write("bad.yaml", "xgm: 1\nmatcher:\n  type: semi_globl\n");
  desk.write("scene/im0.png", "not an image");
  check_usage_error(desk.run("bad.yaml scene"), "bad.yaml:3:");
  check_usage_error(desk.run("p.yaml scene --set matcher.matcher.cost.windw=5"), "windw");
  check_usage_error(xgm::testing::pipeline(desk.path(), ""), "subcommand");
}

TEST_CASE("run: images that cannot be matched are exit 1 with one error that names the file") {
  const Desk desk;
  const auto check_failed = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = desk.run(arguments);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.errors, message));
    CHECK(outcome.errors.find("error:") == outcome.errors.rfind("error:"));
    CHECK_FALSE(std::filesystem::exists(desk / "xgm_output/run.json"));
  };
  const std::string images = " --disparities 0:7 --left scene/im0.png --right ";
  write_png(desk / "small.png", cv::Mat1b(24, 39, 0.0));
  desk.write("junk.png", "junk");
  desk.write("empty.png", "");
  check_failed("p.yaml" + images + "small.png", "small.png: is 39 x 24 pixels");
  check_failed("p.yaml" + images + "junk.png", "junk.png: is no image");
  check_failed("p.yaml" + images + "empty.png", "empty.png: is empty");
  check_failed("p.yaml scene --disparities 40:50", "cannot be seen in images 40 px wide");
  write_pfm(desk / "wide.pfm", cv::Mat1f(24, 41, 1.0f));
  check_failed("p.yaml scene --truth wide.pfm", "wide.pfm: is 41 x 24 pixels");
  check_failed("p.yaml scene --range-maps wide.pfm,wide.pfm", "range maps have the size");
}

TEST_CASE("run: an empty map is exit 1, with the pictures that show why") {
  const Desk desk;
  write_png(desk / "none.png", cv::Mat1b(24, 40, 0.0));
  const Outcome outcome = desk.run("p.yaml scene --left-mask none.png");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "the map is empty"));
  CHECK(std::filesystem::exists(desk / "xgm_output/status.png"));
}

TEST_CASE("run: a range wider than the image is cut to it, and said so") {
  const Desk desk;
  const Outcome outcome = desk.run("p.yaml scene --disparities -1000000:1000000");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.errors, "warning: "));
  CHECK(contains(outcome.errors, "-39 to 39 are searched"));
  CHECK(contains(read_file(desk / "xgm_output/run.json"), "-39 to 39 are searched"));
}

TEST_CASE("run: a plugin file that cannot be loaded is warned of and stops nothing") {
  const Desk desk;
  desk.write("junk.so", "junk");
  const Outcome outcome = desk.run("p.yaml scene --plugin junk.so");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.errors, "junk.so could not be loaded"));
}

#ifndef XGM_SANITIZED  // which needs far more address space than it uses
TEST_CASE("run: more memory than there is is an error, not a killed process") {
  const Desk desk;
  write_png(desk / "l.png", cv::Mat1b(60, 4000, 9.0));
  const std::string arguments = "run p.yaml --left l.png --right l.png --disparities 0:3999";
  const Outcome outcome = xgm::testing::pipeline(desk.path(), arguments, "ulimit -v 1500000 && ");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "memory"));
}
#endif
