// SPDX-License-Identifier: Apache-2.0
// Surveyed points move cameras to where they look.
#include <cmath>

#include "geo/cameras.hpp"
#include "geo/recorder.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/image/control_points.hpp"
#include "xgm/geo/stage/pointing.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;
using xgm::testing::TemporaryFolder;
using xgm::testing::test_data;

namespace {

std::shared_ptr<const Pointing> ground_control(const std::string& file) {
  return geo_stage<Pointing>("{type: ground_control, points: '" + file + "'}");
}

const char* const kHeader = "name,image,column,row,longitude,latitude,height\n";

/// A line of CSV: where a camera that looks `offset` beside the truth shows a point.
std::string line(const SatelliteImage& image, const std::string& name, const GeoPoint& p,
                 cv::Point2d offset) {
  const cv::Point2d seen = image.camera.project(p) + offset;
  std::ostringstream text;
  text.precision(15);
  text << name << ", " << image.file << ".tif, " << seen.x << "," << seen.y << "," << p.longitude
       << "," << p.latitude << "," << p.height << "\n";
  return text.str();
}

}  // namespace

TEST_CASE("the mean offset of surveyed points is given back to the camera, image by image") {
  const TemporaryFolder folder;
  auto [one, two] = xgm::testing::curved_pair();
  two.name = two.file = "other";
  std::string text = kHeader;
  text += line(one, "a", {55.70, -21.20, 900}, {3, -2});
  text += line(one, "b", {55.71, -21.19, 1200}, {3.5, -2.25});
  text += line(one, "c", {55.69, -21.21, 1000}, {2.5, -1.75});
  text += line(one, "far", {56.5, -21.21, 1000}, {0, 0});
  const std::string file = folder.write("points.csv", text);
  Recorder recorder;
  const auto corrected = ground_control(file)->run({one, two}, {{0, 1}}, {}, Context(&recorder));
  const GeoPoint p{55.705, -21.204, 1100};
  CHECK(cv::norm(corrected[0].camera.project(p) - one.camera.project(p) - cv::Point2d(3, -2)) <
        1e-8);
  CHECK(cv::norm(corrected[1].camera.project(p) - two.camera.project(p)) == 0);
  CHECK(recorder.figures.at("curved column_px") == doctest::Approx(3));
  CHECK(recorder.figures.at("curved column_deviation_px") ==
        doctest::Approx(0.5 * std::sqrt(2 / 3.0)));
  CHECK(recorder.figures.at("other points") == 0);
  CHECK(recorder.warned("other: no control point"));
  CHECK(recorder.warned("point far lies beyond"));
}

TEST_CASE("a wrong point is named") {
  const TemporaryFolder folder;
  const auto [one, two] = xgm::testing::curved_pair();
  std::string text = kHeader;
  for (int i = 0; i < 9; ++i) {
    text += line(one, std::to_string(i), {55.7 + i * 1e-3, -21.2, 900}, {1, 1});
  }
  text += line(one, "wrong", {55.7, -21.21, 900}, {41, 1});
  Recorder recorder;
  ground_control(folder.write("points.csv", text))->run({one, two}, {}, {}, Context(&recorder));
  CHECK(recorder.warned("point wrong lies 36"));
}

TEST_CASE("files of control points that cannot be used are refused, with the point and a remedy") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& name, const std::string& text) {
    const std::string file = folder.write(name, text);
    return error_of([&] { read_control_points(file); });
  };
  CHECK(contains(message("a.csv", "image,column,row\n"), "a.csv:1: has no column \"longitude\""));
  CHECK(contains(message("b.csv", std::string(kHeader) + "p,i.tif,1,x,3,4,5\n"),
                 "b.csv:2: \"x\" is no number for \"row\""));
  CHECK(contains(message("c.csv", std::string(kHeader) + "p,i.tif,1,2,3,4\n"), "\"height\""));
  CHECK(contains(message("d.csv", std::string(kHeader) + "p,,1,2,3,4,5\n"), "which image"));
  CHECK(contains(message("e.csv", std::string(kHeader) + "p,i,1,2,-33.6,240.4,5\n"),
                 "longitude, latitude, height"));
  CHECK(contains(message("f.json", "{"), "no GeoJSON"));
  CHECK(contains(message("g.json", "[]"), "FeatureCollection"));
  CHECK(contains(message("h.json", "{\"features\": [{\"properties\": {\"ji\": [1]}}]}"),
                 "point 1 has no property \"ji\""));
  CHECK(contains(message("i.json",
                         "{\"features\": [{\"properties\": {\"ji\": [1, 2]}, "
                         "\"geometry\": {\"coordinates\": [1, 2]}}]}"),
                 "no coordinates"));
  CHECK(contains(message("j.txt", ""), ".geojson"));
  CHECK(contains(error_of([&] { read_control_points(folder / "none.csv"); }), "no such file"));
  const auto [one, two] = xgm::testing::curved_pair();
  const std::string others = folder.write("k.csv", std::string(kHeader) + "p,i.tif,1,2,3,4,5\n");
  CHECK(contains(error_of([&, &a = one] { ground_control(others)->run({a}, {}, {}, {}); }),
                 "it names i.tif, the first image is curved"));
  CHECK(contains(error_of([] { geo_stage<Pointing>("ground_control"); }), "must name a file"));
}

TEST_CASE("QuickBird: surveyed points give the bias of the vendor's camera") {
  const auto data = test_data("a QuickBird image and surveyed points");
  if (!data) return;
  const std::string folder = (*data / "satellite/orthority/tests/data/rpc/").string();
  const SatelliteImage image = open_image(folder + "qb2_basic1b.tif");
  Recorder recorder;
  const auto corrected =
      ground_control(folder + "gcps.geojson")->run({image}, {}, {}, Context(&recorder));
  CHECK(std::abs(recorder.figures.at("qb2_basic1b column_px") - -2.977) < 1e-3);
  CHECK(std::abs(recorder.figures.at("qb2_basic1b row_px") - -2.090) < 1e-3);
  CHECK(std::abs(recorder.figures.at("qb2_basic1b column_deviation_px") - 0.07) < 0.01);
  CHECK(std::abs(recorder.figures.at("qb2_basic1b row_deviation_px") - 0.07) < 0.01);
  MESSAGE("bias " << recorder.figures.at("qb2_basic1b column_px") << ", "
                  << recorder.figures.at("qb2_basic1b row_px") << " px; deviation "
                  << recorder.figures.at("qb2_basic1b column_deviation_px") << ", "
                  << recorder.figures.at("qb2_basic1b row_deviation_px"));
  for (const ControlPoint& p : read_control_points(folder + "gcps.geojson")) {
    CHECK(cv::norm(corrected[0].camera.project(p.ground) - p.pixel) < 0.2);
  }
}
