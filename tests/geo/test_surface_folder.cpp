// SPDX-License-Identifier: Apache-2.0
// What a surface reads is kept, and what lies in its folder is of one run.
#include <doctest/doctest.h>

#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/base/json.hpp"
#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;

namespace fs = std::filesystem;

namespace {

const std::string kQuick = "run dsm_tsgm8 --set filters=[] --set matching=sgm8 ";
const std::string kPair = "--images scene/image_1.tif scene/image_2.tif ";

/// Puts the input where `output` is going to be written; it is as before afterwards.
void check_kept(const SatelliteDesk& desk, const std::string& input, const std::string& output,
                const std::string& arguments) {
  CAPTURE(arguments);
  fs::remove_all(desk / "out");
  fs::create_directory(desk / "out");
  fs::create_hard_link(desk / input, desk / ("out/" + output));
  const std::string before = read_file(desk / input);
  const Outcome outcome = desk.call(kQuick + arguments + " --output out");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "is an input, which would be lost"));
  CHECK(read_file(desk / input) == before);
  CHECK(std::distance(fs::directory_iterator(desk / "out"), {}) == 1);
}

}  // namespace

TEST_CASE("no input is lost to a file of a surface: images, cameras, masks, DEM, area, truth") {
  const SatelliteDesk desk;
  desk.write("a_rpc.txt", rpc_text(desk.scene.views[0].delivered));
  desk.write("b_rpc.txt", rpc_text(desk.scene.views[1].delivered));
  desk.write("area.json", R"({"type": "Polygon", "coordinates":
      [[[6, 45], [7, 45], [7, 46], [6, 46], [6, 45]]]})");
  write_raster(desk / "mask.tif", {cv::Mat1f(128, 128, 1.0F), {}, {}, {}});
  check_kept(desk, "scene/image_2.tif", "orthoimage.tif", kPair);
  check_kept(desk, "a_rpc.txt", "image_1_rpc.txt", kPair + "--cameras a_rpc.txt b_rpc.txt");
  check_kept(desk, "mask.tif", "source.tif", kPair + "--masks mask.tif mask.tif");
  check_kept(desk, "scene/dem.tif", "dsm.tif", kPair + "--dem scene/dem.tif");
  check_kept(desk, "area.json", "run.json", kPair + "--area area.json");
  check_kept(desk, "scene/dsm.tif", "dsm.tif", kPair + "--truth scene/dsm.tif");
  // What an image or a VRT is read with.
  fs::remove_all(desk / "delivered");
  fs::create_directory(desk / "delivered");
  desk.write_image("delivered/image_3.tif", 1);
  check_kept(desk, "delivered/image_3_RPC.TXT", "image_3_rpc.txt",
             "--images scene/image_1.tif delivered/image_3.tif");
  desk.write_vrt("dem.vrt", "scene/dem.tif");
  check_kept(desk, "scene/dem.tif", "dsm.tif", kPair + "--dem dem.vrt,ellipsoid");
}

TEST_CASE("cameras of a run are not put where they would be taken for those of the images") {
  const SatelliteDesk desk;
  const Outcome outcome = desk.call(kQuick + kPair + "--output scene/../scene");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "the camera of scene/image_1.tif that is written there"));
  CHECK_FALSE(fs::exists(desk / "scene/image_1_rpc.txt"));
  CHECK_FALSE(fs::exists(desk / "scene/run.json"));
}

TEST_CASE("a folder holds the files of one surface, and nothing that passes for one of them") {
  const SatelliteDesk desk;
  REQUIRE(desk.call(kQuick + kPair + "--dem scene/dem.tif --output out").exit_code == 0);
  const Json grid = Json::parse(read_file(desk / "out/run.json")).at("grid");
  CHECK(grid.at("epsg").number() == 32632);
  CHECK(contains(grid.at("crs").dump(), "UTM zone 32N"));
  fs::rename(desk / "out/cloud.ply", desk / "cloud.ply");
  desk.write("out/dsm.tif.aux.xml", "<PAMDataset/>");  // statistics that a viewer has kept
  desk.write("out/notes.txt", "mine");
  const std::string again = "run dsm_tsgm8 --clouds cloud.ply --output ";
  REQUIRE(desk.call(again + "out").exit_code == 0);
  // Clouds tell no reasons.
  for (const char* name : {"reasons.tif", "cloud.ply", "image_1_rpc.txt", "dsm.tif.aux.xml"}) {
    CAPTURE(name);
    CHECK_FALSE(fs::exists(desk / (std::string("out/") + name)));
  }
  CHECK(read_file(desk / "out/notes.txt") == "mine");
  fs::create_directory(desk / "other");
  desk.write("other/reasons.tif", "mine");
  const Outcome refused = desk.call(again + "other");
  CAPTURE(refused.errors);
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "reasons.tif is no file that run.json lists"));
  CHECK(read_file(desk / "other/reasons.tif") == "mine");
}
