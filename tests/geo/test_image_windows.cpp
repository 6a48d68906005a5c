// SPDX-License-Identifier: Apache-2.0
// Images of any depth and number of bands.
#include <doctest/doctest.h>
#include <gdal_priv.h>

#include <cmath>

#include "ground/gdal.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/image/satellite_image.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::TemporaryFolder;

namespace {

double value_of(int x, int y, int band) { return 1 + (x + 3 * y + 17 * band) % 100; }

/// 60 x 50 px in blocks of 16; pixel (7, 9) of the first band has no data.
SatelliteImage image_of(const std::string& file, GDALDataType type, int bands) {
  GDALAllRegister();
  const char* const options[] = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", nullptr};
  {
    const DatasetPtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), 60, 50, bands, type, const_cast<char**>(options)));
    REQUIRE(dataset != nullptr);
    for (int band = 1; band <= bands; ++band) {
      cv::Mat1d values(50, 60);
      for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 60; ++x) values(y, x) = value_of(x, y, band);
      }
      if (band == 1) values(9, 7) = 0;
      dataset->GetRasterBand(band)->SetNoDataValue(0);
      REQUIRE(dataset->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, 60, 50, values.data, 60, 50,
                                                     GDT_Float64, 0, 0) == CE_None);
    }
  }
  return {.name = "image",
          .file = file,
          .band = 0,
          .mask = {},
          .size = {60, 50},
          .bands = bands,
          .camera = RpcCamera(RpcModel{}),
          .acquisition = {}};
}

}  // namespace

TEST_CASE("grey levels of 8 and 16 bit, of floats, of one band or the mean of all, by windows") {
  const TemporaryFolder folder;
  for (const GDALDataType type : {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_Float32, GDT_Float64}) {
    for (const int bands : {1, 3}) {
      CAPTURE(type);
      CAPTURE(bands);
      SatelliteImage image = image_of(folder / "image.tif", type, bands);
      for (const int band : {0, 1, bands}) {
        image.band = band;
        const cv::Mat1f window = read_window(image, {-2, 5, 40, 50});
        for (int y = 5; y < 55; ++y) {
          for (int x = -2; x < 38; ++x) {
            const float grey = window(y - 5, x + 2);
            const bool has_data = x >= 0 && y < 50 && !(x == 7 && y == 9 && band <= 1);
            CHECK(std::isnan(grey) == !has_data);
            if (!has_data) continue;
            double expected = 0;
            for (int b = 1; b <= bands; ++b) expected += value_of(x, y, b) / bands;
            if (band > 0) expected = value_of(x, y, band);
            CHECK(grey == doctest::Approx(expected).epsilon(1e-6));
          }
        }
      }
    }
  }
}
