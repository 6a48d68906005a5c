// SPDX-License-Identifier: Apache-2.0
// The page of a surface: what is on it, and that views stand where the record says.
#include <cmath>
#include <numbers>

#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;

namespace {

/// The circle of a direction: north up, straight above in the middle, 30 degrees on the last
/// circle.
std::string circle_of(const Json& image) {
  const double angle = image.at("azimuth_deg").number() * std::numbers::pi / 180;
  const double radius = 130 * image.at("incidence_deg").number() / 30;
  return "cx=\"" + fixed_number(160 + radius * std::sin(angle), 1) + "\" cy=\"" +
         fixed_number(160 - radius * std::cos(angle), 1) + "\"";
}

}  // namespace

TEST_CASE("report of a surface: layers, views, pairs and configuration in one page") {
  const SatelliteDesk desk;
  const Outcome made = desk.call(
      "run dsm_tsgm8 --images scene/image_1.tif scene/image_2.tif --dem scene/dem.tif --report "
      "--truth scene/dsm.tif -o out");
  CAPTURE(made.errors);
  REQUIRE(made.exit_code == 0);
  const std::string page = read_file(desk / "out/report.html");
  const std::string record_text = read_file(desk / "out/run.json");
  const Json record = Json::parse(record_text);
  for (const std::string part :
       {"Heights, shaded", "Orthoimage of the first pair", "Gap between the lines of sight",
        "What heights were made of", "Why cells are empty", "Time and memory", "Configuration",
        "Within 1 m of the truth", "range_prior"}) {
    CAPTURE(part);
    CHECK(contains(page, part));
  }
  CHECK_FALSE(contains(page, "How far the pairs disagree"));  // there is one pair
  CHECK_FALSE(contains(page, "src=\"http"));
  CHECK(contains(record_text, "report.html"));
  const Json& images = record.at("images");
  REQUIRE(images.size() == 2);
  for (const Json& image : images) {
    REQUIRE(image.at("incidence_deg").number() < 30);
    CHECK(contains(page, circle_of(image)));
    CHECK(contains(page, ">" + image.at("name").text() + "</text>"));
  }
  const Json& pair = record.at("pairs").elements().front();
  CHECK(pair.at("convergence_deg").number() > 1);
  CHECK(pair.at("overlap").number() > 0.5);
}

TEST_CASE("report of a surface that was made of clouds") {
  const SatelliteDesk desk;
  const std::string images = "--images scene/image_1.tif scene/image_2.tif --dem scene/dem.tif ";
  REQUIRE(desk.call("run dsm_tsgm8 " + images + "-o out").exit_code == 0);
  CHECK_FALSE(std::filesystem::exists(desk / "out/report.html"));
  REQUIRE(desk.call("run dsm_tsgm8 --clouds out/cloud.ply --report -o again").exit_code == 0);
  const std::string page = read_file(desk / "again/report.html");
  CHECK(contains(page, "Heights, shaded"));
  CHECK_FALSE(contains(page, "From where the images were taken"));
}
