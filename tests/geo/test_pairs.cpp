// SPDX-License-Identifier: Apache-2.0
// What is known of the moment an image was taken, and which pairs that makes.
#include <algorithm>

#include "geo/cameras.hpp"
#include "geo/recorder.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/stage/pairs.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;
using xgm::testing::TemporaryFolder;
using xgm::testing::test_data;

namespace {

/// Three images of one place: leaning to one side, to the other, and just like the first.
std::vector<SatelliteImage> three_images() {
  const auto [one, two] = xgm::testing::curved_pair();
  std::vector<SatelliteImage> images{one, two, one};
  for (std::size_t i = 0; i < 3; ++i) images[i].name = std::string(1, static_cast<char>('a' + i));
  return images;
}

std::vector<std::string> names(const std::vector<SatelliteImage>& images,
                               const std::vector<PairChoice>& pairs) {
  std::vector<std::string> all;
  for (const PairChoice& p : pairs) all.push_back(images[p.base].name + images[p.match].name);
  return all;
}

}  // namespace

TEST_CASE("time, sun and clouds of an .IMD, of DigitalGlobe's XML and of DIMAP") {
  const TemporaryFolder folder;
  const Acquisition imd = read_acquisition(folder.write(
      "a.IMD",
      "BEGIN_GROUP = IMAGE_1\n\tfirstLineTime = 1970-01-02T00:00:01.500000Z;\n\tmeanSunAz = "
      "161.9;\n\tmeanSunEl = 27.6;\n\tcloudCover = 0.125;\nEND_GROUP = IMAGE_1\nEND;\n"));
  CHECK(imd.time == doctest::Approx(86401.5));
  CHECK(imd.sun_azimuth == 161.9);
  CHECK(imd.sun_elevation == 27.6);
  CHECK(imd.cloud_cover == 0.125);
  const Acquisition xml = read_acquisition(folder.write(
      "b.xml",
      "<?xml version=\"1.0\"?><isd><IMD><IMAGE><TLCTIME>2000-03-01T00:00:00Z</TLCTIME>"
      "<CLOUDCOVER>-999</CLOUDCOVER><MEANSUNEL>2.76e+01</MEANSUNEL></IMAGE></IMD></isd>"));
  CHECK(xml.time == 951868800.0);
  CHECK(xml.sun_elevation == 27.6);
  CHECK_FALSE(xml.sun_azimuth);
  CHECK_FALSE(xml.cloud_cover);  // -999 means unknown
  const Acquisition dimap = read_acquisition(folder.write(
      "c.xml",
      "<Dimap_Document><CLOUD_COVERAGE>40</CLOUD_COVERAGE><IMAGING_DATE>1970-01-01</IMAGING_DATE>"
      "<IMAGING_TIME>00:01:00.5Z</IMAGING_TIME><Located_Geometric_Values><LOCATION_TYPE>TopLeft"
      "</LOCATION_TYPE><SUN_AZIMUTH>1</SUN_AZIMUTH></Located_Geometric_Values>"
      "<Located_Geometric_Values><LOCATION_TYPE>Center</LOCATION_TYPE><SUN_AZIMUTH>2</SUN_AZIMUTH>"
      "</Located_Geometric_Values></Dimap_Document>"));
  CHECK(dimap.time == 60.5);
  CHECK(dimap.sun_azimuth == 2.0);
  CHECK(dimap.cloud_cover == 0.4);
}

TEST_CASE("dates that are none are unknown, and files that cannot be read are refused") {
  const TemporaryFolder folder;
  for (const char* time : {"2014-13-19T18:52:50Z", "2014", "", "2014-02-30T00:00:00Z"}) {
    CAPTURE(time);
    const std::string file =
        folder.write("a.imd", "firstLineTime = " + std::string(time) + ";\nmeanSunAz = x;\n");
    CHECK_FALSE(read_acquisition(file).time);
    CHECK_FALSE(read_acquisition(file).sun_azimuth);
  }
  CHECK(contains(error_of([&] { read_acquisition(folder.write("b.xml", "<a>")); }), "no XML"));
  CHECK(contains(error_of([&] { read_acquisition(folder / "none.IMD"); }), "no such file"));
  CHECK_FALSE(find_acquisition(folder / "none.tif").time);
}

TEST_CASE("pairs are chosen by convergence; those closest in time come first") {
  std::vector<SatelliteImage> images = three_images();
  images[0].acquisition = {0, 100, 40, 0.0};
  images[1].acquisition = {86400 * 10, 110, 40, 0.1};
  images[2].acquisition = {86400 * 8.5, 120, 40, std::nullopt};
  Recorder recorder;
  const auto run = [&](const std::string& yaml) {
    return names(images, geo_stage<Pairs>(yaml)->run(images, Context(&recorder)));
  };
  // a and c look along the same lines.
  CHECK(run("by_geometry") == std::vector<std::string>{"bc", "ab"});
  CHECK(recorder.figures.at("a c convergence_deg") < 0.01);
  CHECK(recorder.figures.at("a b convergence_deg") > 5);
  CHECK(recorder.figures.at("a b days") == doctest::Approx(10));
  CHECK(recorder.figures.at("a b overlap") > 0.3);
  CHECK(recorder.warned("c: unknown are cloud_cover"));
  // The angle of two directions 10 degrees apart at 40 degrees of elevation.
  CHECK(recorder.figures.at("a b sun_deg") == doctest::Approx(7.6564).epsilon(1e-4));
  CHECK(run("{type: by_geometry, max_days: 5}") == std::vector<std::string>{"bc"});
  CHECK(run("{type: by_geometry, max_pairs: 1}") == std::vector<std::string>{"bc"});
  CHECK(run("{type: by_geometry, min_convergence: 0}").size() == 3);
  CHECK(run("{type: by_geometry, max_sun_difference: 8, min_convergence: 0}") ==
        std::vector<std::string>{"bc", "ab"});
  // An unknown cloud cover passes, one that is too large does not.
  images[0].acquisition.cloud_cover = 0.9;
  CHECK(run("by_geometry") == std::vector<std::string>{"bc"});
}

TEST_CASE("if no pair fits, the reasons are counted") {
  std::vector<SatelliteImage> images = three_images();
  const auto message = [&](const std::string& yaml) {
    return error_of([&] { geo_stage<Pairs>(yaml)->run(images, Context()); });
  };
  CHECK(contains(message("{type: by_geometry, max_incidence: 0}"), "3 with an image above"));
  CHECK(contains(message("{type: by_geometry, max_convergence: 6, min_convergence: 5.9}"),
                 "1 below min_convergence, 2 above max_convergence"));
  images.pop_back();
  images[1].camera = images[1].camera.cropped({50000, 0});
  CHECK(contains(message("by_geometry"), "1 below min_overlap"));
  CHECK(contains(message("{type: by_geometry, max_convergence: 1}"), "below min_convergence"));
}

TEST_CASE("vendors' metadata: WorldView, Pleiades Neo, and NITF") {
  const auto data = test_data("metadata of vendors");
  if (!data) return;
  const std::string folder = (*data / "satellite/").string();
  const Acquisition wv = read_acquisition(folder + "asp/src/asp/Camera/tests/wv_mvp_1.xml");
  CHECK(wv.time == doctest::Approx(1403203970.787577).epsilon(1e-15));
  CHECK(wv.sun_azimuth == 131.5);
  CHECK(wv.sun_elevation == 73.6);
  CHECK(wv.cloud_cover == 0.0);
  const std::string neo = folder + "asp/tests/test_data/pleiades/";
  const Acquisition pneo = find_acquisition("", neo + "RPC_PNEO3_202111071029126_PAN_trimmed.XML");
  CHECK(pneo.time == doctest::Approx(1636280951.9).epsilon(1e-15));
  REQUIRE(pneo.sun_elevation);
  CHECK(std::abs(*pneo.sun_elevation - 29) < 0.2);
  CHECK(pneo.cloud_cover == 0.0);
  const Acquisition nitf = read_acquisition(folder + "shareloc/tests/data/rpc/wv3_20.NTF");
  CHECK(nitf.time == 1040051789.0);  // 2002-12-16 15:16:29
}
