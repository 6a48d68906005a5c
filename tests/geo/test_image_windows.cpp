// SPDX-License-Identifier: Apache-2.0
// Images of any depth and number of bands.
#include <doctest/doctest.h>
#include <gdal_priv.h>

#include <cmath>

#include "ground/gdal.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/ground/raster.hpp"
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

TEST_CASE("a reduced image has the means of its pixels, of those that may be used") {
  const TemporaryFolder folder;
  SatelliteImage image = image_of(folder / "i.tif", GDT_UInt16, 1);
  cv::Mat1f used(image.size, 1.0F);
  used(cv::Rect(0, 0, 4, 2)).setTo(0);  // half a pixel
  used(cv::Rect(4, 0, 4, 3)).setTo(0);  // more
  write_raster(folder / "mask.tif", {used, {}, {}, {}});
  image.mask = folder / "mask.tif";
  const SatelliteImage small = reduced(image, 4);
  REQUIRE(small.size == cv::Size(15, 12));  // two rows make up no pixel
  const cv::Mat1f whole = read_window(image, {0, 0, 60, 50});
  const cv::Mat1f window = read_window(small, {-1, 0, 17, 13});
  for (int y = 0; y < window.rows; ++y) {
    for (int x = 0; x < window.cols; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      const cv::Point first(4 * (x - 1), 4 * y);
      double sum = 0;
      int count = 0;
      for (int k = 0; k < 16; ++k) {
        const cv::Point p = first + cv::Point(k % 4, k / 4);
        const bool is_there = x > 0 && x <= 15 && y < 12 && !std::isnan(whole(p));
        sum += is_there ? double{whole(p)} : 0;
        count += is_there ? 1 : 0;
      }
      CHECK(std::isnan(window(y, x)) == (count < 8));
      if (count >= 8) CHECK(window(y, x) == doctest::Approx(sum / count).epsilon(1e-6));
    }
  }
  CHECK(std::isnan(window(0, 2)));
  CHECK_FALSE(std::isnan(window(0, 1)));
  const cv::Mat1f twice = read_window(reduced(reduced(image, 2), 2), {-1, 0, 17, 13});
  CHECK(cv::countNonZero(twice == window) == cv::countNonZero(window == window));
}
