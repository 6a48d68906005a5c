// SPDX-License-Identifier: Apache-2.0
// Cameras in the files of vendors and tools: known figures, and the same model from every format.
#include <filesystem>

#include "support/support.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/camera/rpc_camera.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::test_data;

namespace {

std::optional<std::string> satellite(const std::string& what, const std::string& file) {
  const auto data = test_data(what);
  return data ? std::optional((*data / "satellite" / file).string()) : std::nullopt;
}

RpcCamera camera(const std::string& file) { return RpcCamera(read_rpc(file).front()); }

}  // namespace

TEST_CASE("Réunion: the projection and localisation of another implementation") {
  const auto file =
      satellite("RPC tags of a Pleiades crop", "s2p/tests/data/input_pair/img_01.tif");
  if (!file) return;
  const RpcCamera reunion = camera(*file);
  const cv::Point2d pixel = reunion.project({55.6502, -21.2306, 2320});
  CHECK(std::abs(pixel.x - 495.93418171) < 1e-6);
  CHECK(std::abs(pixel.y - 509.15036148) < 1e-6);
  const auto point = reunion.localize({512, 512}, 2320);
  REQUIRE(point);
  CHECK(std::abs(point->longitude - 55.650278274198) < 1e-10);
  CHECK(std::abs(point->latitude - -21.230613676527) < 1e-10);
}

TEST_CASE("one Pleiades camera as .geom, DIMAP 2 XML and GeoTIFF tags") {
  const auto folder = satellite("three formats of one camera", "shareloc/tests/data/rpc/");
  if (!folder) return;
  const std::string number = "PHR1B_P_201709281038393_SEN_PRG_FC_178609-001";
  for (const std::string& name : {number + ".geom", "RPC_" + number + ".XML", number + ".tif"}) {
    CAPTURE(name);
    const cv::Point2d pixel = camera(*folder + name).project({7.0486626607, 43.7277483944, 0});
    // (100.5, 200.5) in shareloc, where the centre of the first pixel is (0.5, 0.5).
    CHECK(std::abs(pixel.x - 100) < 0.01);
    CHECK(std::abs(pixel.y - 200) < 0.01);
  }
}

TEST_CASE("every vendor's file is read, and its model inverts over its domain") {
  const auto folder = satellite("RPC files of many vendors", "");
  if (!folder) return;
  for (const char* name :
       {"rpcm/tests/test_rpc_files/rpc_IKONOS.txt",
        "rpcm/tests/test_rpc_files/rpc_PLANET_L1A.txt",
        "rpcm/tests/test_rpc_files/rpc_PLANET_L1B.txt",
        "rpcm/tests/test_rpc_files/rpc_PLEIADES.xml",
        "rpcm/tests/test_rpc_files/rpc_SPOT6.xml",
        "rpcm/tests/test_rpc_files/rpc_WV1.xml",
        "rpcm/tests/test_rpc_files/rpc_WV2.xml",
        "rpcm/tests/test_rpc_files/rpc_WV3.xml",
        "rpcm/tests/test_rpc_files/JAX_068_001_RGB.json",
        "rpcm/tests/test_rpc_files/20191015_073816_ssc1d3_0011_basic_l1a_panchromatic_dn_RPC.TXT",
        "rpcm/tests/test_rpc_files/"
        "ENMAP01-____L1B-DT0000001011_20220609T081225Z_001_V010111_20230119T143357Z-METADATA.XML",
        "asp/src/asp/Camera/tests/dg_example1.xml",
        "asp/src/asp/Camera/tests/sample.RPB",
        "asp/src/asp/Camera/tests/wv_mvp_1.xml",
        "asp/src/asp/Camera/tests/wv_mvp_2.xml",
        "asp/tests/test_data/pleiades/RPC_PNEO3_202111071029126_PAN_trimmed.XML",
        "orthority/tests/data/rpc/rpc_param.yaml",
        "orthority/tests/data/rpc/qb2_basic1b.tif",
        "shareloc/tests/data/rpc/wv3_20.NTF",
        "shareloc/tests/data/rpc/phr_ventoux/left_image.geom",
        "shareloc/tests/data/rpc/PHRDIMAP_P1BP--2017030824934340CP.XML",
        "shareloc/tests/data/rpc/phr_oise/RPC_PHR1A_P_202503191043438_SEN_7342362101-1.XML"}) {
    CAPTURE(name);
    const std::vector<RpcModel> models = read_rpc(*folder + name);
    REQUIRE_FALSE(models.empty());
    const RpcCamera seen(models.front());
    const RpcModel& m = seen.model();
    int failures = 0;
    double worst = 0;
    for (int k = 0; k < 21 * 21 * 5; ++k) {
      const cv::Point2d pixel(m.column.value(-1 + 0.1 * (k % 21)),
                              m.row.value(-1 + 0.1 * (k / 21 % 21)));
      const auto point = seen.localize(pixel, m.height.value(-1 + 0.5 * (k / 441)));
      if (point) worst = std::max(worst, cv::norm(seen.project(*point) - pixel));
      failures += !point;
    }
    CHECK(worst < 1e-6);
    MESSAGE(std::string(name) << ": " << models.size() << " models, " << failures
                              << " of 2205 not found");
  }
}

TEST_CASE("DigitalGlobe XML: offsets and scales that another tool reads") {
  const auto file = satellite("a DigitalGlobe XML", "asp/src/asp/Camera/tests/dg_example1.xml");
  if (!file) return;
  const RpcModel model = read_rpc(*file).front();
  CHECK(model.column.offset == 17564);
  CHECK(model.row.offset == 11856);
  CHECK(model.column.scale == 17927);
  CHECK(model.row.scale == 12384);
  CHECK(model.longitude.offset == doctest::Approx(-105.2903));
  CHECK(model.latitude.offset == doctest::Approx(39.7454));
  CHECK(model.height.offset == 2281);
  CHECK(model.row_ratio.numerator[0] == doctest::Approx(4.683662e-3));
  CHECK(model.column_ratio.numerator[0] == doctest::Approx(-7.306375e-3));
}

TEST_CASE("files that hold no model are refused, by name and with what would do") {
  const auto folder = satellite("files without an RPC model", "");
  if (!folder) return;
  const auto message = [&](const char* name) {
    try {
      read_rpc(*folder + name);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message("rpcm/tests/test_rpc_files/rpc_unsupported.xml").find("<VRTDataset>") !=
        std::string::npos);
  CHECK(message("asp/tests/test_data/pleiades/DIM_PNEO3_202111071029126_PAN_trimmed.XML")
            .find("RPC_") != std::string::npos);
  CHECK(message("shareloc/tests/data/image/phr_ventoux/left_image.tif").find("no RPC") !=
        std::string::npos);
}
