// SPDX-License-Identifier: Apache-2.0
// pipeline eval, as a user meets it.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

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
using Json = nlohmann::json;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Eight pixels with truth 4, one without. Errors: 0 0 0.75 1.5 3 - - 9; the last one is occluded.
struct Desk : TemporaryFolder {
  Desk() {
    const cv::Mat1f truth = (cv::Mat1f(1, 9) << 4, 4, 4, 4, 4, 4, 4, 4, kNan);
    const cv::Mat1f map = (cv::Mat1f(1, 9) << 4, 4, 4.75, 2.5, 7, kNan, kNan, 13, 4);
    cv::Mat1b mask(1, 9, 255);
    mask(7) = 128;
    mask(8) = 0;
    for (const char* folder : {"scene", "output"})
      std::filesystem::create_directory(*this / folder);
    write_pfm(*this / "truth.pfm", truth);
    write_pfm(*this / "scene/disp0GT.pfm", truth);
    write_pfm(*this / "map.pfm", map);
    write_pfm(*this / "output/disparity.pfm", map);
    write_png(*this / "mask.png", mask);
    write_png(*this / "scene/mask0nocc.png", mask);
    write_png(*this / "scene/im0.png", cv::Mat1b(1, 9, 100));
    write_png(*this / "scene/im1.png", cv::Mat1b(1, 9, 100));
    write("scene/calib.txt", "ndisp=10\n");
  }
  Outcome eval(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), "eval " + arguments);
  }
  Json json(const std::string& arguments) const {
    const Outcome outcome = eval(arguments + " --json -");
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.output);
  }
};

void check_usage(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, message));
  CHECK(outcome.output.empty());
}

void check_one_line(const Outcome& outcome, const std::string& message) {
  check_usage(outcome, message);
  CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("eval: figures of a map and a truth") {
  const Desk desk;
  const Json json = desk.json("map.pfm --truth truth.pfm --thresholds 0.75,2.9");
  const Json& all = json["truth"][0];
  CHECK(json["truth"].size() == 1);
  CHECK(all["judged_pixels"] == 8);
  CHECK(all["invalid"] == 2.0 / 8);
  CHECK(all["coverage"] == 6.0 / 8);
  CHECK(all["average_error_px"] == 14.25 / 6);
  CHECK(all["a50_px"] == 0.75);
  CHECK(all["thresholds"].size() == 2);
  CHECK(all["thresholds"][0]["bad"] == 3.0 / 8);
  CHECK(all["thresholds"][1]["total"] == 4.0 / 8);
  CHECK(json["rules"]["scale"] == 1);
  CHECK(json["rules"]["clip"].is_null());
  CHECK(json["inputs"].size() == 2);
}

TEST_CASE("eval: an output folder and a scene give the same as their files") {
  const Desk desk;
  const Json of_folders = desk.json("output scene");
  const Json of_files = desk.json("map.pfm --truth truth.pfm --mask mask.png");
  CHECK(of_folders["truth"] == of_files["truth"]);
  CHECK(of_folders["truth"].size() == 3);
  CHECK(of_folders["truth"][1]["region"] == "non-occluded");
  CHECK(of_folders["truth"][1]["judged_pixels"] == 7);
  CHECK(of_folders["truth"][2]["judged_pixels"] == 1);
  CHECK(of_folders["inputs"].size() == 3);
}

TEST_CASE("eval: --scale, --clip and ndisp") {
  const Desk desk;
  const Json scaled = desk.json("map.pfm --truth truth.pfm --scale 4 --thresholds 3,6");
  CHECK(scaled["truth"][0]["average_error_px"] == 4 * 14.25 / 6);
  CHECK(scaled["truth"][0]["thresholds"][0]["bad"] == 3.0 / 8);
  CHECK(scaled["truth"][0]["thresholds"][1]["bad"] == 2.0 / 8);
  // 2.5 becomes 4, 4.75, 7 and 13 become 4 as well.
  CHECK(desk.json("map.pfm --truth truth.pfm --clip 4:4")["truth"][0]["average_error_px"] == 0);
  // 13 becomes 10, for the benchmark includes ndisp.
  const Json clipped = desk.json("output scene --clip ndisp");
  CHECK(clipped["truth"][0]["average_error_px"] == 11.25 / 6);
  CHECK(clipped["rules"]["clip"]["last"] == 10);
}

TEST_CASE("eval: KITTI's PNG with divisors and an object map") {
  const Desk desk;
  cv::imwrite(desk / "map.png", cv::Mat1w((cv::Mat1w(1, 4) << 1024, 2560, 0, 640)));
  cv::imwrite(desk / "truth.png", cv::Mat1b((cv::Mat1b(1, 4) << 8, 8, 8, 0)));
  write_png(desk / "objects.png", cv::Mat1b((cv::Mat1b(1, 4) << 0, 3, 0, 0)));
  const Json json =
      desk.json("map.png --divisor 256 --truth truth.png --truth-divisor 2 --objects objects.png");
  REQUIRE(json["truth"].size() == 3);
  CHECK(json["truth"][0]["d1"] == 2.0 / 3);  // 10 instead of 4, and the hole
  CHECK(json["truth"][1]["d1"] == 1.0 / 2);
  CHECK(json["truth"][2]["region"] == "foreground");
  CHECK(json["truth"][2]["d1"] == 1);
  const Json reverse = desk.json("map.png --divisor -256 --truth truth.png --truth-divisor -2");
  CHECK(reverse["truth"][0] == json["truth"][0]);
}

TEST_CASE("eval: a confidence is judged, given or found beside the map") {
  const Desk desk;
  // The surest pixels are the best: the curves are the optimal ones.
  write_pfm(desk / "sure.pfm", (cv::Mat1f(1, 9) << 9, 9, 8, 7, 6, 5, 4, 0, 0));
  const Json given = desk.json("map.pfm --truth truth.pfm --confidence sure.pfm");
  const Json& curve = given["confidence"][0]["thresholds"][1]["bad"];
  CHECK(given["confidence"][0]["pixels"] == 6);
  CHECK(curve["area"] == curve["optimal_area"]);
  CHECK(curve["value"].size() == 20);
  CHECK(curve["value"][19] == 0.5);
  std::filesystem::copy(desk / "sure.pfm", desk / "output/confidence.pfm");
  CHECK(desk.json("output scene")["confidence"][0] == given["confidence"][0]);
  CHECK(contains(desk.eval("output scene").output, "optimal"));
}

TEST_CASE("eval: the table fits 80 columns and shows percent, whatever is asked") {
  const Desk desk;
  write_pfm(desk / "sure.pfm", cv::Mat1f(1, 9, 1.0f));
  for (const std::string thresholds : {"1", "0.25,0.5,1,2,3,4,5,6,7,8,9,10"}) {
    const Outcome outcome =
        desk.eval("output scene --confidence sure.pfm --thresholds " + thresholds);
    REQUIRE(outcome.exit_code == 0);
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) CHECK_MESSAGE(line.size() <= 80, line);
    CHECK(contains(outcome.output, "non-occluded"));
    CHECK(contains(outcome.output, "25.00"));  // invalid
    CHECK(contains(outcome.output, "> 1"));
  }
}

TEST_CASE("eval: CSV holds a line per region, and files are written beside the table") {
  const Desk desk;
  const Outcome outcome = desk.eval("output scene --json e.json --csv e.csv");
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "total error"));
  const std::string csv = read_file(desk / "e.csv");
  CHECK(csv.starts_with("region,judged_pixels,invalid,average_error_px,"));
  CHECK(contains(csv, "\nall,8,0.25,2.375,"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  std::istringstream lines(csv);
  std::string heading, line;
  std::getline(lines, heading);
  while (std::getline(lines, line)) CHECK(commas(line) == commas(heading));
  CHECK(Json::parse(read_file(desk / "e.json"))["truth"].size() == 3);
  CHECK(desk.eval("output scene --csv -").output == csv);
}

TEST_CASE("eval: a map without any disparity has shares, and errors that are null") {
  const Desk desk;
  write_pfm(desk / "empty.pfm", cv::Mat1f(1, 9, kNan));
  const Json json = desk.json("empty.pfm --truth truth.pfm --confidence map.pfm");
  CHECK(json["truth"][0]["invalid"] == 1);
  CHECK(json["truth"][0]["average_error_px"].is_null());
  CHECK(json["truth"][0]["a99_px"].is_null());
  CHECK_FALSE(json.contains("confidence"));
  CHECK(desk.eval("empty.pfm --truth truth.pfm").exit_code == 0);
}

TEST_CASE("eval: pictures are no disparities") {
  const Desk desk;
  DisparityMap map({9, 1});
  for (int x = 0; x < 9; ++x) map.set(0, x, static_cast<float>(x));
  write_png(desk / "output/disparity.png", disparity_picture(map));
  write_png(desk / "grey.png", cv::Mat1b(1, 9, 100));
  check_one_line(desk.eval("output/disparity.png --truth truth.pfm"), "is a colour picture");
  check_one_line(desk.eval("output/disparity.png --divisor 4 --truth truth.pfm"),
                 "is a colour picture");
  check_one_line(desk.eval("grey.png --truth truth.pfm"), "as pictures for display do");
  check_one_line(desk.eval("map.pfm --truth grey.png"), "--truth-divisor");
  CHECK(desk.eval("map.pfm --truth grey.png --truth-divisor 25").exit_code == 0);
}

TEST_CASE("eval: mistakes are one line each and exit 2") {
  const Desk desk;
  write_pfm(desk / "small.pfm", cv::Mat1f(1, 3, 1.0f));
  write_pfm(desk / "none.pfm", cv::Mat1f(1, 9, kNan));
  std::filesystem::create_directory(desk / "bare");
  check_usage(desk.eval(""), "map is required");
  check_usage(desk.eval("no.pfm --truth truth.pfm"), "no.pfm");
  check_usage(desk.eval("map.pfm --truth no.pfm"), "no.pfm");
  check_usage(desk.eval("map.pfm scene --truth truth.pfm"), "--truth");
  check_usage(desk.eval("map.pfm --mask mask.png"), "--truth");
  check_usage(desk.eval("map.pfm --truth truth.pfm --frobnicate"), "frobnicate");
  check_one_line(desk.eval("map.pfm"), "add --truth FILE or a SCENE_DIR");
  check_one_line(desk.eval("bare --truth truth.pfm"), "has no disparity.pfm");
  check_usage(desk.eval("map.pfm bare"), "bare: is no scene");
  check_one_line(desk.eval("small.pfm --truth truth.pfm"), "9 x 1");
  check_one_line(desk.eval("small.pfm scene"), "9 x 1");
  check_one_line(desk.eval("map.pfm --truth truth.pfm --confidence small.pfm"), "confidence is 3");
  check_one_line(desk.eval("map.pfm --truth none.pfm"), "no pixel to judge by");
  check_one_line(desk.eval("map.pfm --truth mask.png --truth-divisor 0"), "other than 0");
  for (const char* thresholds : {"x", "1,", "1,,2", "-1", "2,1", "1,1", "nan", "inf", "1;2"}) {
    check_one_line(
        desk.eval(std::string("map.pfm --truth truth.pfm --thresholds='") + thresholds + "'"),
        "--thresholds");
  }
  for (const char* scale : {"0", "-4", "nan"}) {
    check_one_line(desk.eval(std::string("map.pfm --truth truth.pfm --scale=") + scale), "--scale");
  }
  check_one_line(desk.eval("map.pfm --truth truth.pfm --clip 5"), "--clip 5: write MIN:MAX");
  check_one_line(desk.eval("map.pfm --truth truth.pfm --clip 9:0"), "did you mean 0:9?");
  check_one_line(desk.eval("map.pfm --truth truth.pfm --clip ndisp"), "write --clip MIN:MAX");
  check_one_line(desk.eval("map.pfm --truth truth.pfm --json - --csv -"), "standard output");
}

TEST_CASE("eval: a file that cannot be written is a failure, not silence") {
  const Desk desk;
  const Outcome outcome = desk.eval("map.pfm --truth truth.pfm --json no/where.json");
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "no/where.json"));
  CHECK(desk.eval("map.pfm --truth truth.pfm > /dev/full").exit_code == 1);
}

TEST_CASE("eval: a run of other images than the scene's is warned of") {
  const Desk desk;
  const auto record = [&](const char* left) {
    const FileIdentity identity = identify_file(desk / left);
    const Json input{
        {"role", "left"}, {"file", left}, {"bytes", identity.bytes}, {"fnv1a64", identity.fnv1a64}};
    desk.write("output/run.json", Json{{"scene", {{"inputs", Json::array({input})}}}}.dump());
    return desk.eval("output scene");
  };
  CHECK(record("scene/im0.png").errors.empty());
  const Outcome other = record("mask.png");
  CHECK(other.exit_code == 0);
  CHECK(contains(other.errors, "is a run of other images (mask.png) than those of scene scene"));
}
