// SPDX-License-Identifier: Apache-2.0
// pipeline explain and run --explain, as a user meets them.
#include <doctest/doctest.h>

#include <cmath>
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

/// A scene of 40 x 24 pixels whose disparity is 3 everywhere.
struct Desk : TemporaryFolder {
  Desk() {
    write("p.yaml",
          "xgm: 1\n"
          "matcher:\n"
          "  type: left_right\n"
          "  matcher:\n"
          "    type: semi_global\n"
          "    cost: {type: census, window: 5}\n"
          "    penalty: {type: constant, p1: 4, p2: 20}\n"
          "    aggregation: {type: sgm, directions: 4}\n");
    std::filesystem::create_directory(*this / "scene");
    const ImagePair pair = xgm::testing::shifted_pair({40, 24}, 3, 5);
    write_png(*this / "scene/im0.png", picture(pair.base));
    write_png(*this / "scene/im1.png", picture(pair.match));
    write("scene/calib.txt", "ndisp=8\n");
    write_pfm(*this / "truth.pfm", cv::Mat1f(24, 40, 3.F));
  }
  Outcome call(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), arguments);
  }
};

}  // namespace

TEST_CASE("explain: the text ends with the reason, and JSON says the same") {
  const Desk desk;
  const Outcome text = desk.call("explain p.yaml scene 20 12 --truth truth.pfm --json pixel.json");
  INFO(text.errors);
  REQUIRE(text.exit_code == 0);
  CHECK(text.output.starts_with("pixel (20, 12): 3 px, valid; truth 3 px\n"));
  CHECK(contains(text.output, "where: right: within 1 px of the truth\n"));
  CHECK(text.output.ends_with("why: matched by selection wta at full scale (3)\n"));
  const auto json = nlohmann::json::parse(read_file(desk / "pixel.json"));
  CHECK(json["x"] == 20);
  CHECK(json["levels"][0]["range"] == nlohmann::json{0, 7});
  CHECK(json["levels"][0]["costs"].size() == 8);
  CHECK(json["levels"][0]["winner"]["disparity"] == 3);
  CHECK(json["levels"][0]["reverse"]["x"] == 17);
  const Outcome only_json = desk.call("explain p.yaml scene 20 12 --truth truth.pfm --json -");
  CHECK(nlohmann::json::parse(only_json.output) == json);
}

TEST_CASE("explain: images, or the sample pair, stand in for the scene") {
  const Desk desk;
  const Outcome images = desk.call(
      "explain p.yaml 20 12 --left scene/im0.png --right scene/im1.png --disparities 0:7");
  CHECK(images.output.starts_with("pixel (20, 12): 3 px, valid\n"));
  const Outcome sample = desk.call("explain p.yaml 600 400");
  CHECK(sample.exit_code == 0);
  CHECK(sample.output.starts_with("pixel (600, 400): "));
  CHECK_FALSE(std::filesystem::exists(desk / "xgm_output"));
}

TEST_CASE("explain: a pixel outside of the image, or none at all, is the user's mistake") {
  const Desk desk;
  const Outcome outside = desk.call("explain p.yaml scene 40 12");
  CHECK(outside.exit_code == 2);
  CHECK(contains(outside.errors, "pixel 40 12 lies outside of the images, which are 40 x 24"));
  const Outcome no_number = desk.call("explain p.yaml scene 20 middle");
  CHECK(no_number.exit_code == 2);
  CHECK(contains(no_number.errors, "'20 middle' is no pixel"));
  CHECK(desk.call("explain p.yaml scene").exit_code == 2);
  CHECK(
      desk.call("explain p.yaml scene 1 2 --left scene/im0.png --right scene/im1.png").exit_code ==
      2);
}

TEST_CASE("run --explain keeps single pixels and grids in explain.json") {
  const Desk desk;
  const Outcome outcome =
      desk.call("run p.yaml scene --output out --explain 20,12 --explain 3,4 --explain every=10");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(read_file(desk / "out/explain.json"));
  REQUIRE(json.size() == 2 + 4 * 2);
  CHECK(json[0]["x"] == 20);
  CHECK(json[1]["y"] == 4);
  const cv::Mat1f map = read_pfm(desk / "out/disparity.pfm");
  for (const auto& pixel : json) {
    const float disparity = map(pixel["y"].get<int>(), pixel["x"].get<int>());
    if (pixel["disparity"].is_null()) {
      CHECK_FALSE(std::isfinite(disparity));
    } else {
      CHECK(pixel["disparity"].get<float>() == disparity);
    }
  }
}

TEST_CASE("run --explain: mistakes are found") {
  const Desk desk;
  for (const std::string faulty : {"20", "20,", "a,b", "every=0", "every=x", "-1,3"}) {
    const Outcome outcome = desk.call("run p.yaml scene --explain=" + faulty);
    CAPTURE(faulty);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, "--explain " + faulty));
    CHECK_FALSE(std::filesystem::exists(desk / "xgm_output"));
  }
  const Outcome outside = desk.call("run p.yaml scene --explain 3,24");
  CHECK(outside.exit_code == 2);
  CHECK(contains(outside.errors, "40 x 24"));
}
