// SPDX-License-Identifier: Apache-2.0
// Mistakes of users with satellite images: one message each, which names the file and the remedy,
// before anything is matched.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/geo/image/footprint.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;
using xgm::testing::text_of;

namespace fs = std::filesystem;

namespace {

const std::string kPair = "--images scene/image_1.tif scene/image_2.tif ";

/// The message has all parts; nothing has been matched, and nothing is left of the run.
void check_refused(const SatelliteDesk& desk, const std::string& arguments,
                   const std::vector<std::string>& parts) {
  CAPTURE(arguments);
  const Outcome outcome = desk.call("run dsm_tsgm8 " + arguments + " --output out");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.output.empty());
  const std::string label = "error: ";
  CHECK(contains(outcome.errors, label));
  CHECK(std::ranges::count(outcome.errors, '\n') == 1);
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(contains(outcome.errors, part));
  }
  CHECK_FALSE(fs::exists(desk / "out"));
}

RpcModel moved_east(RpcModel camera, double degrees) {
  camera.longitude.offset += degrees;
  return camera;
}

}  // namespace

TEST_CASE("images: without a camera, twice, a folder, a text, missing, no two") {
  const SatelliteDesk desk;
  desk.write_image("plain.tif", 1, false);
  check_refused(desk, "--images scene/image_1.tif plain.tif",
                {"plain.tif: holds no RPC", "_RPC.TXT"});
  check_refused(desk, "--images scene/image_1.tif scene/../scene/image_1.tif",
                {"scene/image_1.tif", "twice", "two views"});
  fs::copy(desk / "scene/image_1.tif", desk / "copy.tif");
  check_refused(desk, "--images scene/image_1.tif copy.tif",
                {"image_1.tif and copy.tif", "same place", "given twice"});
  fs::create_directory(desk / "other");
  fs::copy(desk / "scene/image_2.tif", desk / "other/image_1.tif");
  check_refused(desk, "--images scene/image_1.tif other/image_1.tif",
                {"other/image_1.tif", "same name", "rename"});
  check_refused(desk, "--images scene/image_1.tif other",
                {"other: is a folder", "name a file in it"});
  desk.write("text.tif", "no image");
  check_refused(desk, "--images scene/image_1.tif text.tif", {"text.tif: is no raster"});
  check_refused(desk, "--images scene/image_1.tif none.tif", {"none.tif: there is no such file"});
  check_refused(desk, "--images scene/image_1.tif", {"two satellite images"});
}

TEST_CASE("what stands in the wrong place: images, values, a scene, a truth without a CRS") {
  const SatelliteDesk desk;
  check_refused(desk, "--images scene/image_1.tif,scene/image_2.tif",
                {"image_1.tif,scene/image_2.tif is one", "blanks between them"});
  check_refused(desk, "scene/image_1.tif scene/image_2.tif",
                {"image_1.tif' is an image", "those of satellites as --images FILE FILE"});
  check_refused(desk, kPair + "--area 10 20 64 64",
                {"scene excludes --images", "'20' is taken for the scene"});
  const Outcome pairs = desk.call("run tsgm8 scene/scene.yaml --output out");
  CHECK(pairs.exit_code == 2);
  CHECK(contains(pairs.errors, "scenes of satellite images, --images"));
  CHECK(contains(pairs.errors, "such as dsm_tmgm16"));
  write_raster(desk / "true.tif", {cv::Mat1f(30, 40, 420.0F), {}, {}, {}});
  check_refused(desk, kPair + "--truth true.tif", {"true.tif: this truth has no CRS"});
  for (const char* call : {"run scene/scene.yaml --output out", "check scene/scene.yaml"}) {
    const Outcome outcome = desk.call(call);
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, "is a scene of satellite images; name a pipeline before it"));
    CHECK(std::ranges::count(outcome.errors, '\n') == 1);
  }
}

TEST_CASE("images: of different ground, of different bands, no such band") {
  const SatelliteDesk desk;
  desk.write("a_rpc.txt", rpc_text(desk.scene.views[0].delivered));
  desk.write("b_rpc.txt", rpc_text(moved_east(desk.scene.views[1].delivered, 1)));
  check_refused(desk, kPair + "--cameras a_rpc.txt b_rpc.txt",
                {"image_1.tif and scene/image_2.tif", "do not show the same ground"});
  check_refused(desk, kPair + "--cameras a_rpc.txt", {"cameras", "1 for 2 images"});
  desk.write("a_rpc.txt", "LINE_OFF: 3\n");
  check_refused(desk, kPair + "--cameras a_rpc.txt b_rpc.txt", {"a_rpc.txt", "incomplete"});
  desk.write_image("three.tif", 3);
  check_refused(desk, "--images scene/image_1.tif three.tif",
                {"three.tif: has 3 bands", "image_1.tif has 1", "--band"});
  check_refused(desk, "--band 2 --images scene/image_1.tif three.tif",
                {"image_1.tif: has 1 band, no band 2", "--band"});
}

TEST_CASE("masks: of another size, too few, no raster") {
  const SatelliteDesk desk;
  write_raster(desk / "small.tif", {cv::Mat1f(3, 4, 1.0F), {}, {}, {}});
  check_refused(desk, kPair + "--masks small.tif small.tif",
                {"small.tif: this mask has 4 x 3 px", "image_1.tif has 128 x 128 px"});
  check_refused(desk, kPair + "--masks small.tif", {"masks", "1 for 2 images"});
  check_refused(desk, kPair + "--masks none.tif scene", {"none.tif: there is no such file"});
  desk.write("mask.txt", "1");
  check_refused(desk, kPair + "--masks mask.txt mask.txt", {"mask.txt: is no raster"});
}

TEST_CASE("DEM: elsewhere, without a datum or a CRS, of a wrong CRS, exchanged axes, no file") {
  const SatelliteDesk desk;
  Raster dem = desk.scene.dem;
  const Raster right = dem;
  dem.place.left += 1e5;
  write_raster(desk / "far.tif", dem);
  check_refused(desk, kPair + "--dem far.tif",
                {"far.tif: this DEM covers longitudes", "images show"});
  dem = right;
  dem.crs = horizontal(dem.crs);
  write_raster(desk / "bare.tif", dem);
  check_refused(desk, kPair + "--dem bare.tif", {"bare.tif", "counted from", "bare.tif,egm96"});
  check_refused(desk, kPair + "--dem bare.tif,sea", {"'sea' is no vertical datum", "egm96"});
  check_refused(desk, kPair + "--dem bare.tif,egm2008", {"bare.tif", "lacks the grid"});
  dem.crs = "EPSG:4326";  // but the coordinates are metres
  write_raster(desk / "wrong.tif", dem);
  check_refused(desk, kPair + "--dem wrong.tif,ellipsoid",
                {"wrong.tif", "no degrees", "gdal_edit"});
  dem.crs = "EPSG:32660";  // another zone of UTM
  write_raster(desk / "zone.tif", dem);
  check_refused(desk, kPair + "--dem zone.tif,ellipsoid", {"zone.tif: this DEM covers"});
  dem.crs.clear();
  write_raster(desk / "no_crs.tif", dem);
  check_refused(desk, kPair + "--dem no_crs.tif,ellipsoid", {"no_crs.tif: this DEM has no CRS"});
  const cv::Vec4d ground = desk.ground();
  dem = {cv::Mat1f(40, 40, 420.0F),
         {ground[1] - 0.02, ground[2] + 0.02, 1e-3, -1e-3},
         "EPSG:4326",
         {}};
  write_raster(desk / "exchanged.tif", dem);
  check_refused(desk, kPair + "--dem exchanged.tif,ellipsoid",
                {"exchanged.tif", "exchanged; give"});
  check_refused(desk, kPair + "--dem none.tif", {"none.tif: there is no such file"});
  fs::create_directory(desk / "empty");
  check_refused(desk, kPair + "--dem empty", {"empty: this folder holds no raster"});
  desk.write("dem.txt", "400");
  check_refused(desk, kPair + "--dem dem.txt", {"dem.txt: is no raster"});
  check_refused(desk, kPair + "--set range_prior.type=dem_sculpting",
                {"range_prior", "--dem FILE"});
}

TEST_CASE("area: elsewhere, exchanged, empty, beyond the image, no polygon") {
  const SatelliteDesk desk;
  const std::string exchanged = text_of(swapped(desk.ground()));
  check_refused(desk, kPair + "--area 0,0,1,1",
                {"image_1.tif", "nothing of the requested area", "it shows longitudes"});
  check_refused(desk, kPair + "--area " + exchanged, {"image_1.tif", "longitudes first"});
  check_refused(desk, kPair + "--area 10,100,12,101",
                {"latitudes lie between", "longitudes first"});
  check_refused(desk, kPair + "--area 6,45,5,46", {"6,45,5,46", "WEST < EAST"});
  check_refused(desk, kPair + "--area 6,45", {"6,45", "COLUMN,ROW:WIDTHxHEIGHT"});
  check_refused(desk, kPair + "--area 100,20:64x64",
                {"column 164", "image_1.tif has 128 x 128 px"});
  desk.write("points.geojson", R"({"type": "Point", "coordinates": [6.4, 45.2]})");
  check_refused(desk, kPair + "--area points.geojson",
                {"points.geojson: holds no polygon", "POINT"});
  desk.write("text.geojson", "no area");
  check_refused(desk, kPair + "--area text.geojson", {"text.geojson: is no area"});
  check_refused(desk, kPair + "--area scene/image_1.tif",
                {"image_1.tif: is a raster without a CRS"});
}

TEST_CASE("filters that need a confidence are refused where matching gives none") {
  const SatelliteDesk desk;
  const std::string set = "--set 'filters=[{type: confidence_threshold, min: 0.5}]' ";
  check_refused(desk, kPair + set, {"filters", "needs a confidence", "give the matching part one"});
  const std::string with = "--set matching.matcher.matcher.matcher.confidence=peak_ratio";
  CHECK(desk.call("check dsm_tsgm8 " + set + with).exit_code == 0);
}

TEST_CASE("a scene in YAML: all mistakes at once, each with its place") {
  const SatelliteDesk desk;
  desk.write("s.yaml",
             "images: [scene/image_1.tif, scene/image_3.tif]\n"
             "mask: [a.tif, b.tif]\n"
             "dem: scene\n"
             "band: 0\n"
             "area: [6, 45]\n"
             "band: 1\n");
  const Outcome outcome = desk.call("run dsm_tsgm8 s.yaml --output out");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  for (const std::string place :
       {"s.yaml:1:29: error: there is no file", "s.yaml:2:1: error: there is no key 'mask'",
        "did you mean 'masks'", "s.yaml:4:7: error: band must be", "s.yaml:5:7: error: area 6,45",
        "s.yaml:6:1: error: 'band' is written twice"}) {
    CAPTURE(place);
    CHECK(contains(outcome.errors, place));
  }
  CHECK_FALSE(fs::exists(desk / "out"));
  desk.write("s.yaml", "dem: scene/dem.tif\n");
  check_refused(desk, "s.yaml", {"s.yaml:1:1", "images"});
  desk.write("s.yaml", "images: [\n");
  check_refused(desk, "s.yaml", {"s.yaml:2:", "no YAML"});
  check_refused(desk, "scene", {"scene: is a folder", "--images"});
  check_refused(desk, "none.yaml", {"none.yaml: there is no such file"});
  check_refused(desk, "", {"--images"});
}

TEST_CASE("options of pairs of images, which are never ignored in silence") {
  const SatelliteDesk desk;
  desk.write("mask.png", "no image");
  for (const std::string option :
       {"--disparities 0:9", "--range-maps a.pfm,b.pfm", "--depth d.tiff", "--cloud c.ply",
        "--dump '*'", "--explain 3,4", "--explain every=9", "--tiles auto", "--memory-limit 1GB",
        "--nodata 0", "--left-mask mask.png", "--right-mask mask.png",
        "--truth mask.png --truth-divisor 2", "--truth mask.png --truth-nodata 0",
        "--truth mask.png --truth-mask mask.png"}) {
    const std::size_t name = option.rfind("--");
    check_refused(desk, kPair + option,
                  {option.substr(name, option.find(' ', name) - name) + ": is for pairs of images",
                   "makes surfaces; "});
  }
  for (const std::string option : {"--scene one", "--dataset kitti"}) {
    check_refused(desk, "scene/scene.yaml " + option, {"is for pairs of images"});
  }
}

TEST_CASE("commands for one pair refuse pipelines that make surfaces, before any work") {
  const SatelliteDesk desk;
  for (const auto& call : {std::pair<std::string, std::string>{"plan dsm_tsgm8", "--images"},
                           {"speed tsgm8,dsm_tsgm8", "'matching'"},
                           {"explain dsm_tsgm8 3 4", "reasons.tif"}}) {
    CAPTURE(call.first);
    const Outcome outcome = desk.call(call.first);
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output.empty());
    CHECK(std::ranges::count(outcome.errors, '\n') == 1);
    CHECK(contains(outcome.errors, "dsm_tsgm8.yaml: makes surfaces of satellite images"));
    CHECK(contains(outcome.errors, call.second));
  }
  for (const std::string option : {"--dataset kitti", "--submit kitti", "--thresholds 1",
                                   "--scale 4", "--clip", "--region all", "--memory-limit 1GB"}) {
    CAPTURE(option);
    const Outcome outcome =
        desk.call("bench --pipelines dsm_tsgm8 --data scene --output out " + option);
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, option.substr(0, option.find(' ')) + ": is for pairs"));
    CHECK_FALSE(fs::exists(desk / "out"));
  }
}

TEST_CASE("a run that is killed leaves no part of a file, and the next one works") {
  const SatelliteDesk desk;
  const std::string run = "run dsm_tsgm8 " + kPair + "--dem scene/dem.tif --output out";
  const std::vector<std::string> known{
      "dsm.tif",         "pairs.tif", "spread.tif",     "gap.tif",   "source.tif",
      "orthoimage.tif",  "dsm.png",   "reasons.tif",    "cloud.ply", "image_1_rpc.txt",
      "image_2_rpc.txt", "run.json",  "unfinished.json"};
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(desk.call(run).exit_code == 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
  int killed = 0;
  for (const double share : {0.3, 0.6, 0.75, 0.85, 0.9, 0.95, 0.98}) {
    CAPTURE(share);
    const Outcome outcome =
        desk.call(run, "timeout -s KILL " + std::to_string(share * whole.count()) + " ");
    killed += outcome.exit_code == 0 ? 0 : 1;
    if (!fs::exists(desk / "out")) continue;
    for (const auto& entry : fs::directory_iterator(desk / "out")) {
      CAPTURE(entry.path());
      CHECK(std::ranges::count(known, entry.path().filename().string()) == 1);
      if (entry.path().extension() == ".tif") CHECK_NOTHROW(read_raster(entry.path().string()));
    }
  }
  CHECK(killed > 0);
  const Outcome outcome = desk.call(run);
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(fs::exists(desk / "out/run.json"));
  CHECK_FALSE(fs::exists(desk / "out/unfinished.json"));
}
