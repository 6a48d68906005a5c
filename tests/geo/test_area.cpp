// SPDX-License-Identifier: Apache-2.0
// Which part of the ground is wanted.
#include "xgm/geo/ground/area.hpp"

#include <doctest/doctest.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geo/satellite_desk.hpp"
#include "ground/gdal.hpp"
#include "support/support.hpp"
#include "xgm/geo/run/surface_files.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;
using xgm::testing::TemporaryFolder;

namespace {

const std::string kPolygon = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
    [[[6.1, 45.1], [6.2, 45.1], [6.2, 45.3], [6.1, 45.1]]]}},
  {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon", "coordinates":
    [[[[6.0, 45], [6.05, 45], [6.05, 45.2], [6.0, 45.0]]]]}}]})";

void check_polygon(const Outline& outline) {
  REQUIRE(outline.size() == 1);
  REQUIRE(outline[0].size() == 3);
  const DegreeBox box = bounds_of(outline);
  for (int i = 0; i < 4; ++i) {
    CHECK(box[i] == doctest::Approx(DegreeBox(6.1, 45.1, 6.2, 45.3)[i]).epsilon(1e-9));
  }
}

/// A layer of one triangle in UTM.
void write_shapefile(const std::string& file) {
  GDALAllRegister();
  const DatasetPtr dataset(GetGDALDriverManager()
                               ->GetDriverByName("ESRI Shapefile")
                               ->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  REQUIRE(dataset != nullptr);
  OGRSpatialReference utm;
  utm.importFromEPSG(32632);
  OGRLayer* const layer = dataset->CreateLayer("area", &utm, wkbPolygon, nullptr);
  REQUIRE(layer != nullptr);
  const CrsTransform to_utm("EPSG:4326", "EPSG:32632");
  OGRLinearRing ring;
  for (const cv::Point2d p :
       {cv::Point2d(6.1, 45.1), cv::Point2d(6.2, 45.1), cv::Point2d(6.2, 45.3)}) {
    const cv::Vec3d place = to_utm.forward({p.x, p.y, 0});
    ring.addPoint(place[0], place[1]);
  }
  ring.closeRings();
  OGRPolygon polygon;
  polygon.addRing(&ring);
  OGRFeature feature(layer->GetLayerDefn());
  feature.SetGeometry(&polygon);
  REQUIRE(layer->CreateFeature(&feature) == OGRERR_NONE);
}

/// Jordan's curve theorem by a ray to the east, edge by edge.
bool inside(const Outline& rings, cv::Point2d p) {
  bool odd = false;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const cv::Point2d a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    }
  }
  return odd;
}

}  // namespace

TEST_CASE("an area is a box, a window of the first image, or a file") {
  const WantedArea box = parse_area("55.64, -21.24,55.66,-21.22");
  REQUIRE(box.box);
  CHECK(*box.box == DegreeBox(55.64, -21.24, 55.66, -21.22));
  const WantedArea window = parse_area("100,200:1024x512");
  CHECK_FALSE(window.box);
  CHECK(window.window == cv::Rect(100, 200, 1024, 512));
  CHECK_FALSE(parse_area("").box);
  for (const char* wrong : {"1,2,3", "1,2,3,4,5", "1,2:3", "1,2:0x5", "-1,2:3x5", "a", "1,2,3,nan",
                            "1,2:3x5,", "1;2;3;4"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_area(wrong), UsageError);
  }
}

TEST_CASE("polygons are read from GeoJSON, KML and Shapefile, the corners of rasters, in degrees") {
  const TemporaryFolder folder;
  const Outline both = read_outline(folder.write("both.geojson", kPolygon));
  CHECK(both.size() == 2);
  CHECK(bounds_of(both)[0] == 6.0);
  check_polygon(read_outline(folder.write(
      "area.kml",
      "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark>"
      "<Polygon><outerBoundaryIs><LinearRing><coordinates>6.1,45.1 6.2,45.1 6.2,45.3 6.1,45.1"
      "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>")));
  write_shapefile(folder / "area.shp");
  check_polygon(read_outline(folder / "area.shp"));
  write_raster(folder / "r.tif",
               {cv::Mat1f(20, 10, 1.0F), {6.1, 45.3, 0.01, -0.01}, "EPSG:4326", {}});
  const Outline raster = read_outline(folder / "r.tif");
  REQUIRE(raster.size() == 1);
  CHECK(cv::norm(raster[0][2] - cv::Point2d(6.2, 45.1)) < 1e-9);
}

TEST_CASE("cells outside of polygons are emptied: those that a ray to the east says are outside") {
  const CrsTransform to_utm("EPSG:4326", "EPSG:32632");
  Raster raster{cv::Mat1f(70, 90, 1.0F), {500000, 5000000, 2, -2}, "EPSG:32632", {}};
  // A concave ring, a hole, and a part of its own, in the raster's CRS.
  const Outline rings{
      {{500010.318, 4999990.159},
       {500150.318, 4999980.159},
       {500100.318, 4999930.159},
       {500170.318, 4999880.159},
       {500020.318, 4999870.159}},
      {{500040.318, 4999950.159}, {500080.318, 4999945.159}, {500060.318, 4999900.159}},
      {{500160.318, 4999995.159}, {500175.318, 4999995.159}, {500171.318, 4999950.159}}};
  Outline degrees = rings;
  for (auto& ring : degrees) {
    for (cv::Point2d& p : ring) {
      const cv::Vec3d place = to_utm.inverse({p.x, p.y, 0});
      p = {place[0], place[1]};
    }
  }
  Raster all = raster;
  all.values = raster.values.clone();
  clear_outside({}, all);
  CHECK(cv::countNonZero(all.values == 1) == 70 * 90);
  clear_outside(degrees, raster);
  int left = 0;
  for (int y = 0; y < 70; ++y) {
    for (int x = 0; x < 90; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      const bool is_left = !std::isnan(raster.values(y, x));
      CHECK(is_left == inside(rings, raster.place.centre(x, y)));
      left += is_left ? 1 : 0;
    }
  }
  CHECK(left > 1500);
}

TEST_CASE("a surface of a polygon, of a window, and of a scene in YAML") {
  const SatelliteDesk desk;
  const DegreeBox g = desk.ground();
  const double west = g[0] + (g[2] - g[0]) / 4, east = g[2] - (g[2] - g[0]) / 4;
  const double south = g[1] + (g[3] - g[1]) / 4, north = g[3] - (g[3] - g[1]) / 4;
  const nlohmann::json triangle{
      {"type", "Polygon"},
      {"coordinates", {{{west, south}, {east, south}, {east, north}, {west, south}}}}};
  desk.write("area.geojson", triangle.dump());
  desk.write("s.yaml",
             "images:\n- scene/image_1.tif\n- scene/image_2.tif\ndem: scene/dem.tif\n"
             "area: area.geojson\n");
  const Outcome scene = desk.call("run dsm_tsgm8 s.yaml --output out");
  CAPTURE(scene.errors);
  REQUIRE(scene.exit_code == 0);
  const Raster dsm = read_raster(desk / "out/dsm.tif");
  const CrsTransform to_grid("EPSG:4326", dsm.crs);
  const auto cell = [&](double longitude, double latitude) {
    const cv::Vec3d place = to_grid.forward({longitude, latitude, 0});
    const cv::Point2d c = dsm.place.cell({place[0], place[1]});
    return dsm.values(cvRound(c.y), cvRound(c.x));
  };
  // One place in the triangle, and its image in the other half of the box.
  CHECK_FALSE(std::isnan(cell(west + 0.75 * (east - west), south + 0.25 * (north - south))));
  CHECK(std::isnan(cell(west + 0.25 * (east - west), south + 0.75 * (north - south))));

  const Outcome window = desk.call("run dsm_tsgm8 s.yaml --area 32,32:64x64 --output window");
  CAPTURE(window.errors);
  REQUIRE(window.exit_code == 0);
  const Raster part = read_raster(desk / "window/dsm.tif");
  const double side = 64 * desk.scene.spec.gsd;
  CHECK(std::abs(part.values.cols * part.place.step_x - side) < side / 4);
  CHECK(std::abs(part.values.rows * part.place.step_x - side) < side / 4);
}
