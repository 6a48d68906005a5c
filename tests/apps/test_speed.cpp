// SPDX-License-Identifier: Apache-2.0
// pipeline speed, as a user meets it.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

constexpr const char* kOneView = XGM_SOURCE_DIR "/tests/bench/sgm8_one_view.yaml";

/// A scene to race on.
struct Track : TemporaryFolder {
  Track() {
    const ImagePair pair = xgm::testing::shifted_pair({48, 24}, 3, 5);
    std::filesystem::create_directories(*this / "scene");
    write_png(*this / "scene/im0.png", picture(pair.base));
    write_png(*this / "scene/im1.png", picture(pair.match));
    write("scene/calib.txt", "ndisp=8\n");
  }
  Outcome speed(const std::string& arguments, const std::string& before = {}) const {
    return xgm::testing::pipeline(path(), "speed " + arguments, before);
  }
};

void check_usage(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, message));
  CHECK_FALSE(contains(outcome.errors, "round"));
}

}  // namespace

TEST_CASE("pipelines are timed beside each other and all modes of OpenCV") {
  const Track track;
  const Outcome outcome =
      track.speed(std::string(kOneView) + ",tsgm8 scene --threads 1 --repeat 2 --json times.json");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "48 x 24 px, 8 disparities, 1 thread, medians of 2 rounds"));
  CHECK(contains(outcome.output, "| sgm8_one_view "));
  CHECK(contains(outcome.output, "| stages of tsgm8 ("));
  CHECK(contains(outcome.output, "| x SGBM_3WAY |"));
  const auto json = nlohmann::json::parse(read_file(track / "times.json"));
  REQUIRE(json["times"].size() == 6);
  for (const auto& times : json["times"]) CHECK(times["seconds"].size() == 2);
}

TEST_CASE("SIMD targets are chosen by option or by XGM_SIMD, and OpenCV can be left out") {
  const Track track;
  const Outcome chosen = track.speed("sgm8 scene --repeat 1 --opencv none --simd scalar,scalar");
  CHECK(chosen.exit_code == 0);
  CHECK(contains(chosen.output, "| sgm8     | scalar |"));
  CHECK_FALSE(contains(chosen.output, "OpenCV"));
  const Outcome forced =
      track.speed("sgm8 scene --repeat 1 --opencv hh --json -", "XGM_SIMD=scalar ");
  CHECK(forced.exit_code == 0);
  const auto json = nlohmann::json::parse(forced.output);
  REQUIRE(json["times"].size() == 2);
  CHECK(json["times"][0]["simd"] == "scalar");
  CHECK(json["times"][1]["name"] == "OpenCV HH");
}

TEST_CASE("mistakes are told before anything is timed") {
  const Track track;
  check_usage(track.speed("sgm9 scene"), "sgm9");
  check_usage(track.speed("sgm8,tsgm9 scene"), "tsgm9");
  check_usage(track.speed("sgm8 scene --opencv hh5"),
              "there is no StereoSGBM mode 'hh5'; did you mean 'hh'?");
  check_usage(track.speed("sgm8 scene --simd mmx"), "there is no SIMD target 'mmx'");
  check_usage(track.speed("sgm8 scene --repeat 0"), "--repeat");
  check_usage(track.speed("sgm8 nowhere"), "nowhere");
  check_usage(track.speed("sgm8 scene --json nowhere/times.json"), "--json");
  check_usage(track.speed("sgm8 scene --rpeat 3"), "did you mean '--repeat'?");
}
