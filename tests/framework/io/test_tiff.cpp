// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <tiffio.h>

#include <opencv2/imgcodecs.hpp>

#include "io/unscaled_image.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;
using xgm::testing::write_tiff;

namespace {

constexpr int kWidth = 37, kHeight = 21;  // no multiple of a tile or strip

/// Each pixel of each band has another value, in whole numbers that every type can hold.
std::vector<cv::Mat> bands_of(int depth, int count) {
  std::vector<cv::Mat> bands;
  for (int i = 0; i < count; ++i) {
    cv::Mat1i band(kHeight, kWidth);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) band(y, x) = x + 2 * y + 20 * i;
    }
    band.convertTo(bands.emplace_back(), depth);
  }
  return bands;
}

bool equal(const cv::Mat1f& plane, const cv::Mat& band) {
  cv::Mat1f expected;
  band.convertTo(expected, CV_32F);
  return plane.size() == expected.size() && cv::norm(plane, expected, cv::NORM_INF) == 0;
}

/// Which pixels of a one-band file have data: 'x', the others '.'.
std::string valid_pixels(const std::string& file, const std::vector<double>& no_data = {}) {
  const UnscaledImage raster = read_unscaled(file, no_data);
  std::string text;
  for (int x = 0; x < raster.size().width; ++x) text += raster.is_valid(0, x) ? 'x' : '.';
  return text;
}

/// An image of zeros of a kind that no matrix has.
void write_samples(const std::string& file, int format, int bits) {
  TIFF* const tiff = TIFFOpen(file.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 16);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 4);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  std::vector<unsigned char> row(16 * 16);
  for (std::uint32_t y = 0; y < 4; ++y) TIFFWriteScanline(tiff, row.data(), y);
  TIFFClose(tiff);
}

}  // namespace

TEST_CASE("tiff: samples that are not read are named, with a remedy") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  const auto says = [&](int format, int bits) {
    write_samples(file, format, bits);
    const std::string error = error_of([&] { read_unscaled(file); });
    CHECK(contains(error, "gdal_translate -ot Float32 " + file));
    return error;
  };
  CHECK(contains(says(SAMPLEFORMAT_UINT, 32), file + ": has 32-bit unsigned numbers"));
  CHECK(contains(says(SAMPLEFORMAT_UINT, 4), "4-bit unsigned numbers"));
  CHECK(contains(says(SAMPLEFORMAT_INT, 64), "64-bit signed numbers"));
  CHECK(contains(says(SAMPLEFORMAT_IEEEFP, 16), "16-bit floats"));
  CHECK(contains(says(SAMPLEFORMAT_COMPLEXIEEEFP, 64), "complex numbers"));
  write_samples(file, SAMPLEFORMAT_UINT, 12);
  CHECK(read_unscaled(file).planes.front()(0, 0) == 0);
}

TEST_CASE(
    "tiff: every type, in strips and tiles, bands together and apart, gives what was stored") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  for (const int depth : {CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F}) {
    for (const int count : {1, 3}) {
      for (int style = 0; style < 8; ++style) {
        CAPTURE(depth);
        CAPTURE(count);
        CAPTURE(style);
        const std::vector<cv::Mat> bands = bands_of(depth, count);
        write_tiff(file, bands,
                   {.bands_apart = (style & 1) != 0,
                    .tiled = (style & 2) != 0,
                    .compressed = (style & 4) != 0});
        const UnscaledImage raster = read_unscaled(file);
        CHECK(raster.depth == depth);
        CHECK(raster.valid.empty());
        REQUIRE(raster.planes.size() == bands.size());
        for (std::size_t i = 0; i < bands.size(); ++i) {
          CHECK(equal(raster.planes[bands.size() - 1 - i], bands[i]));  // blue comes first
        }
      }
    }
  }
}

TEST_CASE("tiff: what OpenCV reads rightly is read alike, orientations included") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  for (int orientation = 1; orientation <= 8; ++orientation) {
    CAPTURE(orientation);
    write_tiff(file, bands_of(CV_16U, 1), {.orientation = orientation});
    const UnscaledImage raster = read_unscaled(file);
    CHECK(raster.depth == CV_16U);
    CHECK(equal(raster.planes.front(), cv::imread(file, cv::IMREAD_UNCHANGED)));
  }
}

TEST_CASE("tiff: the last of two or four bands is alpha, unless the file says that it is not") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  for (const int depth : {CV_8U, CV_16U, CV_32F}) {
    for (const int count : {2, 4}) {
      for (const bool has_alpha : {true, false}) {
        std::vector<cv::Mat> bands = bands_of(depth, count);
        bands.back().at<uchar>(0, 0) = 1;
        bands.back().row(3).setTo(0);
        write_tiff(file, bands, {.has_alpha = has_alpha});
        const UnscaledImage raster = read_unscaled(file);
        CHECK(raster.planes.size() == static_cast<std::size_t>(count - 1));
        CHECK(raster.is_valid(2, 5));
        CHECK(raster.is_valid(3, 5) != has_alpha);
      }
    }
  }
}

TEST_CASE("tiff: GDAL_NODATA is compared in the type of the pixels") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  const auto valid = [&](const cv::Mat& pixels, const std::string& tag) {
    write_tiff(file, {pixels}, {.no_data = tag});
    return valid_pixels(file);
  };
  const float least = std::numeric_limits<float>::lowest();
  const cv::Mat1f floats = (cv::Mat1f(1, 4) << -9999, 0, least, 0.1f);
  CHECK(valid(floats, "-9999") == ".xxx");
  CHECK(valid(floats, " -9999.0 ") == ".xxx");
  CHECK(valid(floats, "0") == "x.xx");
  CHECK(valid(floats, "-3.4028234663852886e+38") == "xx.x");
  CHECK(valid(floats, "-3.40282346638529e+38") == "xx.x");  // above the largest float by a hair
  CHECK(valid(floats, "0.1") == "xxx.");                    // the float nearest to it
  CHECK(valid(floats, "nan") == "xxxx");
  CHECK(valid(floats, "1") == "xxxx");
  const cv::Mat1d doubles = (cv::Mat1d(1, 3) << 0.1, 16777217, 16777216);
  CHECK(valid(doubles, "0.1") == ".xx");
  CHECK(valid(doubles, "16777217") == "x.x");  // as floats both are the same
  CHECK(valid(cv::Mat1w((cv::Mat1w(1, 3) << 0, 65535, 7)), "65535") == "x.x");
  CHECK(valid(cv::Mat1w((cv::Mat1w(1, 3) << 0, 65535, 7)), "-1") == "xxx");
  CHECK(valid(cv::Mat1w((cv::Mat1w(1, 3) << 0, 65535, 7)), "7.5") == "xxx");
  CHECK(valid(cv::Mat1b((cv::Mat1b(1, 3) << 0, 255, 7)), "-9999") == "xxx");
  CHECK(valid(cv::Mat1b((cv::Mat1b(1, 3) << 0, 255, 7)), "256") == "xxx");
  CHECK(valid(cv::Mat1s((cv::Mat1s(1, 3) << -32768, 0, 7)), "-32768") == ".xx");
  CHECK(valid(cv::Mat1i((cv::Mat1i(1, 2) << -2147483647, -2147483646)), "-2147483647") == ".x");
}

TEST_CASE(
    "tiff: a colour pixel has no data where all bands have the value; callers may add values") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  const cv::Mat1b red = (cv::Mat1b(1, 4) << 7, 7, 9, 1), green = (cv::Mat1b(1, 4) << 7, 8, 9, 1);
  for (const bool apart : {false, true}) {
    write_tiff(file, {red, green, green}, {.no_data = "7", .bands_apart = apart});
    CHECK(valid_pixels(file) == ".xxx");
    CHECK(valid_pixels(file, {9, 1}) == ".x..");
  }
}

TEST_CASE("tiff: a tag that is no number, or speaks of other samples, is an error with a remedy") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.tif";
  for (const char* tag : {"none", "-9999,0", "1 2", " "}) {
    CAPTURE(tag);
    write_tiff(file, bands_of(CV_32F, 1), {.no_data = tag});
    const std::string error = error_of([&] { read_unscaled(file); });
    CHECK(contains(error, file + ": its tag GDAL_NODATA says '"));
    CHECK(contains(error, "gdal_edit.py"));
  }
  write_tiff(file, bands_of(CV_8U, 1), {.no_data = "0", .white_is_zero = true});
  CHECK(contains(error_of([&] { read_unscaled(file); }), "convert it to grey or RGB"));
  write_tiff(file, bands_of(CV_8U, 1), {.white_is_zero = true});
  CHECK(read_unscaled(file).planes.front()(0, 0) == 255);
  write_tiff(file, bands_of(CV_8U, 5));
  CHECK(contains(error_of([&] { read_unscaled(file); }), "has 5 channels"));
}
