// SPDX-License-Identifier: Apache-2.0
// Pixels without data, and files that are not whole, as a user meets them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;
using xgm::testing::write_tiff;
using Json = nlohmann::json;

namespace {

constexpr int kWidth = 80, kHeight = 24;
constexpr int kWithout = 20;  // columns at the left without data
constexpr float kNoData = -9999;

/// Float images of a pair, whose leftmost columns hold the value of no data; maps of 4 px.
struct Desk : TemporaryFolder {
  explicit Desk(const std::string& tag = {}) {
    const ImagePair pair = xgm::testing::shifted_pair({kWidth, kHeight}, 4, 5);
    write_image("left.tif", pair.base.planes.front(), tag);
    write_image("right.tif", pair.match.planes.front(), tag);
    cv::Mat1f map(kHeight, kWidth, 4.0f);
    write_pfm(*this / "map.pfm", map);
    map.colRange(0, kWithout).setTo(kNoData);
    write_tiff(*this / "marked.tif", {map});
    map.colRange(0, kWithout).setTo(-1);
    write_tiff(*this / "doubtful.tif", {map});
  }
  void write_image(const std::string& name, cv::Mat1f image, const std::string& tag) const {
    image.colRange(0, kWithout).setTo(kNoData);
    write_tiff(*this / name, {image}, {.no_data = tag});
  }
  Outcome call(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), arguments);
  }
  Outcome run(const std::string& arguments) const {
    return call("run sgm8 --left left.tif --right right.tif --output out " + arguments);
  }
  Json record() const { return Json::parse(read_file(*this / "out/run.json")); }
};

double average_error(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.output)["truth"][0]["average_error_px"].get<double>();
}

}  // namespace

TEST_CASE(
    "run: pixels without data are masked, be it by tag, by option, or by a value like a mark") {
  const std::string interval = "--disparities 0:15 ";
  const Desk tagged("-9999"), plain;
  REQUIRE(tagged.run(interval).exit_code == 0);
  const std::string map = read_file(tagged / "out/disparity.pfm");
  CHECK(tagged.record()["status_shares"]["masked"].get<double>() >= 0.999 * kWithout / kWidth);
  CHECK(tagged.record()["warnings"].empty());

  REQUIRE(plain.run(interval + "--nodata -9999").exit_code == 0);
  CHECK(read_file(plain / "out/disparity.pfm") == map);
  CHECK(plain.record()["warnings"].empty());

  const Outcome silent = plain.run(interval);
  REQUIRE(silent.exit_code == 0);
  CHECK(read_file(plain / "out/disparity.pfm") == map);
  CHECK(contains(silent.errors, "480 of 1920 pixels hold -9999"));
  CHECK(plain.record()["warnings"].size() == 2);
}

TEST_CASE("run: range maps may be TIFF, and leave out what has no data") {
  const Desk desk("-9999");
  const Outcome outcome = desk.run("--range-maps marked.tif,marked.tif --nodata -9999");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(desk.record()["disparities"]["first"] == 4);
  CHECK(desk.record()["warnings"].empty());
}

TEST_CASE("eval: values like marks are no disparities, doubtful ones are named") {
  const Desk desk;
  for (const char* files : {"map.pfm --truth marked.tif", "marked.tif --truth map.pfm"}) {
    const Outcome outcome = desk.call(std::string("eval --json - ") + files);
    CHECK(average_error(outcome) == 0);
    CHECK(contains(outcome.errors, "marked.tif: 480 of 1920 pixels hold -9999"));
  }
  const Outcome doubtful = desk.call("eval map.pfm --truth doubtful.tif --json -");
  CHECK(average_error(doubtful) > 1);
  CHECK(contains(doubtful.errors, "hold -1, the only negative value"));
  CHECK(contains(doubtful.errors, "--truth-nodata"));
  const Outcome said = desk.call("eval map.pfm --truth doubtful.tif --truth-nodata -1 --json -");
  CHECK(average_error(said) == 0);
  CHECK(said.errors.empty());
  const Outcome map_said = desk.call("eval doubtful.tif --nodata 7,-1 --truth map.pfm --json -");
  CHECK(average_error(map_said) == 0);
  CHECK(map_said.errors.empty());
}

TEST_CASE("--nodata adds to what the data set names") {
  const Desk desk;
  desk.write("dataset.yaml", "{type: folder, left: left.tif, right: right.tif, no_data: [-9999]}");
  for (const char* option : {"", " --nodata 0"}) {
    CAPTURE(option);
    const Outcome outcome =
        desk.call(std::string("run sgm8 . --disparities 0:15 --output out") + option);
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    CHECK(desk.record()["warnings"].empty());
    CHECK(desk.record()["status_shares"]["masked"].get<double>() >= 0.999 * kWithout / kWidth);
  }
}

TEST_CASE("--nodata takes numbers, and needs images") {
  const Desk desk;
  for (const char* value : {"none", "1,", "-9999;0"}) {
    const Outcome outcome = desk.run(std::string("--disparities 0:15 --nodata '") + value + "'");
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, std::string("--nodata ") + value + ": write numbers"));
  }
  CHECK(contains(desk.call("run sgm8 --nodata 0").errors, "--nodata needs images"));
}

TEST_CASE("a cut JPEG is one line about the file, and nothing else") {
  const Desk desk;
  std::vector<uchar> bytes;
  cv::Mat1b image;
  xgm::testing::random_image({kWidth, kHeight}, 3).planes.front().convertTo(image, CV_8U);
  REQUIRE(cv::imencode(".jpg", image, bytes));
  desk.write("cut.jpg",
             {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size()) * 2 / 3});
  const Outcome outcome = desk.call(
      "run sgm8 --left cut.jpg --right cut.jpg --disparities 0:15 --log-level error --output out");
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "cut.jpg: is cut short or damaged"));
  CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
}
