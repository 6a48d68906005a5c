// SPDX-License-Identifier: Apache-2.0
// Clouds as files, and surfaces made of them.
#include <cmath>
#include <map>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/json.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/run/recorded_surface.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/ply.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;
using xgm::testing::test_data;

namespace {

PointCloud cloud_of(const std::string& base, const std::string& match,
                    const std::vector<cv::Vec3d>& points) {
  PointCloud cloud;
  cloud.base = base;
  cloud.match = match;
  float step = 0;
  for (const cv::Vec3d& point : points) {
    cloud.add(point, 10 + step, 0.25F * step, step == 1);
    ++step;
  }
  return cloud;
}

/// Text PLY of points "x y z".
std::string text_cloud(const std::string& comment, const std::string& points, int count,
                       const std::string& x = "x") {
  return "ply\nformat ascii 1.0\ncomment created by S2P\ncomment " + comment + "\nelement vertex " +
         std::to_string(count) + "\nproperty float " + x +
         "\nproperty float y\nproperty float z\nend_header\n" + points;
}

RecordedSurface rasterise(const std::vector<std::string>& clouds, const std::string& folder,
                          const std::vector<Override>& overrides, const std::string& area = {}) {
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  SurfaceFiles files{};
  files.clouds = clouds;
  files.area = area;
  SurfaceRecordRequest request;
  request.folder = folder;
  return record_surface(require_pipeline("dsm_tsgm8", registry, overrides), files, request);
}

bool same(const cv::Mat1f& a, const cv::Mat1f& b) {
  if (a.size() != b.size()) return false;
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](float p, float q) { return p == q || (std::isnan(p) && std::isnan(q)); });
}

/// What the independent program does with the points of a cell: a running mean, each step of which
/// is rounded to a float.
cv::Mat1f running_means(const GridPoints& points, const Raster& grid) {
  cv::Mat1f means(grid.values.size(), std::numeric_limits<float>::quiet_NaN());
  cv::Mat1f counts(means.size(), 0.0F);
  for (const cv::Vec3d& point : points) {
    const int x = static_cast<int>(std::floor((point[0] - grid.place.left) / grid.place.step_x));
    const int y = static_cast<int>(std::floor((grid.place.top - point[1]) / grid.place.step_x));
    float& count = counts(y, x);
    const double sum = count > 0 ? double{count} * double{means(y, x)} : 0;
    means(y, x) = static_cast<float>((point[2] + sum) / (1 + double{count}));
    ++count;
  }
  return means;
}

}  // namespace

TEST_CASE("clouds that are written are read as they were, pair by pair") {
  const TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<PointCloud> pairs{
      cloud_of("a b", "c", {{359922.4028450314, 7651732.706638366, 2272.625054137199}, {1, 2, 3}}),
      cloud_of("a b", "d", {{4, 5, 6}})};
  pairs[1].gaps[0] = static_cast<float>(nan);
  write_clouds(folder / "c.ply", "EPSG:32740", 0.5, pairs);
  const CloudSet read = read_clouds({folder / "c.ply"});
  CHECK(read.crs == "EPSG:32740");
  CHECK(read.resolution == 0.5);
  REQUIRE(read.pairs.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(read.pairs[i].base == pairs[i].base);
    CHECK(read.pairs[i].match == pairs[i].match);
    CHECK(read.pairs[i].points == pairs[i].points);
    CHECK(read.pairs[i].greys == pairs[i].greys);
    CHECK(read.pairs[i].fills == pairs[i].fills);
  }
  CHECK(read.pairs[0].gaps == pairs[0].gaps);
  CHECK(std::isnan(read.pairs[1].gaps[0]));
  const std::string head = read_head(folder / "c.ply", 1000);
  CHECK(contains(head, "comment crs EPSG:32740\ncomment projection: UTM 40S\n"));
  CHECK(contains(head, "comment vertical_datum WGS 84 ellipsoid\n"));
  CHECK(contains(head, "comment pair 1 a b / d\n"));
  CHECK(contains(head, "property double z\nproperty uchar red\n"));
  // Files of the same images are one pair.
  const CloudSet twice = read_clouds({folder / "c.ply", folder / "c.ply"});
  REQUIRE(twice.pairs.size() == 2);
  CHECK(twice.pairs[0].points.size() == 4);
}

TEST_CASE("clouds of s2p are read, with each way of saying the CRS; points without place are not") {
  const TemporaryFolder folder;
  const std::map<std::string, std::string> ways{{"projection: UTM 40S", "EPSG:32740"},
                                                {"projection: UTM 7N", "EPSG:32607"},
                                                {"projection: CRS epsg:2154", "EPSG:2154"}};
  for (const auto& way : ways) {
    const std::string &comment = way.first, &crs = way.second;
    CAPTURE(comment);
    write_file(folder / "t.ply", text_cloud(comment, "1 2 3\nnan 2 3\n4 5 6.5\n", 3));
    const CloudSet read = read_clouds({folder / "t.ply"});
    CHECK(crs_name(read.crs) == crs_name(crs));
    CHECK(read.resolution == 0);
    REQUIRE(read.pairs.size() == 1);
    CHECK(read.pairs[0].base == folder / "t.ply");
    CHECK(read.pairs[0].points == std::vector<cv::Vec3d>{{1, 2, 3}, {4, 5, 6.5}});
    CHECK(std::isnan(read.pairs[0].gaps[1]));
  }
}

TEST_CASE("clouds that cannot be placed are refused by name") {
  const TemporaryFolder folder;
  const auto why = [&](const std::string& bytes) {
    write_file(folder / "bad.ply", bytes);
    const std::string error = error_of([&] { read_clouds({folder / "bad.ply"}); });
    CHECK(error.starts_with(folder / "bad.ply"));
    return error;
  };
  CHECK(contains(why(text_cloud("of a test", "1 2 3", 1)), "does not say its CRS"));
  CHECK(contains(why(text_cloud("projection: UTM 61S", "1 2 3", 1)), "does not say its CRS"));
  CHECK(contains(why(text_cloud("crs EPSG:4326", "1 2 3", 1)), "is not projected"));
  CHECK(contains(why(text_cloud("crs EPSG:0", "1 2 3", 1)), "no coordinate reference system"));
  CHECK(contains(why(text_cloud("crs EPSG:2154\ncomment vertical_datum egm96", "1 2 3", 1)),
                 "above 'egm96'"));
  CHECK(contains(why(text_cloud("crs EPSG:2154", "1 2 3", 1, "t")), "no property 'x'"));
  CHECK(contains(why(text_cloud("crs EPSG:2154", "1 2 3", 2)), "cut off"));
  const std::string pair = "1 2 0.5\n";
  std::string fraction = text_cloud("crs EPSG:2154", pair, 1);
  fraction.insert(fraction.find("end_header"), "property float pair\n");
  CHECK(contains(why(fraction + " 0.5\n"), "its pair is no whole number"));
  write_file(folder / "good.ply", text_cloud("crs EPSG:2154", "1 2 3", 1));
  write_file(folder / "other.ply", text_cloud("projection: UTM 31N", "1 2 3", 1));
  CHECK(contains(error_of([&] {
                   read_clouds({folder / "good.ply", folder / "other.ply"});
                 }),
                 "other.ply: is in WGS 84 / UTM zone 31N"));
}

TEST_CASE("a surface is made of clouds: cells by hand, borders to the east and south") {
  const TemporaryFolder folder;
  // Cells of 2 m. The second point lies on the border of two cells, the last one on the grid's
  // edge.
  const std::vector<cv::Vec3d> first{{500000.5, 4000001.5, 10},
                                     {500002, 4000001, 20},
                                     {500002.5, 4000000.5, 30},
                                     {500004, 4000000, 50}};
  const std::vector<cv::Vec3d> second{{500000.7, 4000001.1, 12}};
  write_clouds(folder / "c.ply", "EPSG:32631", 2,
               {cloud_of("a", "b", first), cloud_of("a", "c", second)});
  const RecordedSurface made = rasterise({folder / "c.ply"}, folder / "out", {});
  const Raster dsm = read_raster(folder / "out/dsm.tif");
  CHECK(dsm.place.left == 500000);
  CHECK(dsm.place.top == 4000002);
  REQUIRE(dsm.values.size() == cv::Size(3, 2));
  const float none = std::numeric_limits<float>::quiet_NaN();
  CHECK(same(dsm.values, (cv::Mat1f(2, 3) << 11, 25, none, none, none, 50)));
  CHECK(dsm.metadata.at("vertical_datum") == kEllipsoidalHeights);
  const auto layer = [&](const std::string& name) {
    return read_raster(folder / ("out/" + name)).values;
  };
  CHECK(same(layer("pairs.tif"), (cv::Mat1f(2, 3) << 2, 1, 0, 0, 0, 1)));
  // Gaps are 0, 0.25, 0.5, 0.75 in the first cloud, of which the second point is filled.
  CHECK(same(layer("gap.tif"), (cv::Mat1f(2, 3) << 0, 0.375, none, none, none, 0.75)));
  CHECK(same(layer("source.tif"), (cv::Mat1f(2, 3) << 1, 1, 0, 0, 0, 1)));
  CHECK(read_raster(folder / "out/source.tif").metadata.at("code_2") == "filled");
  CHECK(same(layer("orthoimage.tif"), (cv::Mat1f(2, 3) << 10, 11.5, none, none, none, 13)));
  CHECK_FALSE(std::filesystem::exists(folder / "out/reasons.tif"));
  CHECK_FALSE(std::filesystem::exists(folder / "out/cloud.ply"));
  const Json record = Json::parse(read_file(folder / "out/run.json"));
  CHECK(record.at("cells").at("count").number() == 6);
  CHECK(record.at("pairs").elements()[1].at("match").text() == "c");
  CHECK(made.covered == 0.5);
}

TEST_CASE(
    "a cell whose points are all filled says so; smaller cells and an area can be asked for") {
  const TemporaryFolder folder;
  write_clouds(folder / "c.ply", "EPSG:32631", 2,
               {cloud_of("a", "b", {{500000.5, 4000001.5, 10}, {500003, 4000001, 20}})});
  rasterise({folder / "c.ply"}, folder / "out", {{"resolution", "1"}});
  CHECK(same(read_raster(folder / "out/source.tif").values,
             (cv::Mat1f(2, 4) << 1, 0, 0, 0, 0, 0, 0, 2)));
  // On the central meridian of the zone, where 0.0001 degrees are 9 m.
  const std::string area = "3.00001,36.14,3.00011,36.1401";
  const RecordedSurface cut = rasterise({folder / "c.ply"}, folder / "cut", {}, area);
  CHECK(cut.result.grid.place.left == 500000);
  CHECK(cut.result.grid.size.width == 5);
}

TEST_CASE("clouds are refused before any work if no surface can be made of them") {
  const TemporaryFolder folder;
  write_file(folder / "t.ply", text_cloud("crs EPSG:2154", "1 2 3\n", 1));
  CHECK(contains(error_of([&] { rasterise({folder / "t.ply"}, folder / "out", {}); }),
                 "--set resolution"));
  write_file(folder / "far.ply", text_cloud("crs EPSG:2154", "1 2 3\n9e9 2 3\n", 2));
  CHECK(contains(error_of([&] {
                   rasterise({folder / "far.ply"}, folder / "out", {{"resolution", "1"}});
                 }),
                 "is too large"));
  SurfaceFiles both{};
  both.images = {"a.tif", "b.tif"};
  both.clouds = {folder / "t.ply"};
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  CHECK(
      contains(error_of([&] { record_surface(require_pipeline("dsm_tsgm8", registry), both, {}); }),
               "--clouds"));
}

TEST_CASE("the cloud of another program becomes its surface") {
  const auto data = test_data("a cloud of s2p and the surface that it made of it");
  if (!data) return;
  const std::string s2p = (*data / "satellite/s2p/tests/data/").string();
  const std::string file = s2p + "input_ply/cloud.ply";
  const TemporaryFolder folder;
  rasterise({file}, folder / "out", {{"resolution", "0.4"}, {"surface", "mean"}});
  const Raster ours = read_raster(folder / "out/dsm.tif");
  Raster theirs = read_raster(s2p + "expected_output/plyflatten/dsm_40cm.tiff");
  // Its grids have a row more than the points need.
  REQUIRE(theirs.values.rows == ours.values.rows + 1);
  for (const float last : theirs.values.row(ours.values.rows)) CHECK(std::isnan(last));
  theirs.values = theirs.values.rowRange(0, ours.values.rows).clone();
  REQUIRE(ours.values.size() == theirs.values.size());
  CHECK(ours.place.left == doctest::Approx(theirs.place.left).epsilon(1e-12));
  CHECK(ours.place.top == doctest::Approx(theirs.place.top).epsilon(1e-12));
  int cells = 0, equal = 0, other_holes = 0;
  double largest = 0;
  for (int y = 0; y < ours.values.rows; ++y) {
    for (int x = 0; x < ours.values.cols; ++x) {
      const float a = ours.values(y, x), b = theirs.values(y, x);
      other_holes += std::isnan(a) != std::isnan(b) ? 1 : 0;
      if (std::isnan(a) || std::isnan(b)) continue;
      ++cells;
      equal += a == b ? 1 : 0;
      largest = std::max(largest, std::abs(double{a} - double{b}));
    }
  }
  MESSAGE(cells << " cells, " << cells - equal << " differ, by " << largest << " m at most");
  CHECK(cells == 120601);
  CHECK(other_holes == 0);
  CHECK(cells - equal <= 19);         // of 163 that hold two points
  CHECK(largest <= 1.0 / (1 << 12));  // the last digit of a float of 2048 to 4096 m
  // The rest is the other program's rounding.
  CHECK(same(running_means(read_clouds({file}).pairs.at(0).points, ours), theirs.values));
}
