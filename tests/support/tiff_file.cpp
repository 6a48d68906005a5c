// SPDX-License-Identifier: Apache-2.0
#include "support/tiff_file.hpp"

#include <doctest/doctest.h>
#include <tiffio.h>

#include <memory>

namespace xgm::testing {
namespace {

constexpr int kTile = 16, kStripRows = 5;
constexpr ttag_t kGdalNoData = 42113;

int format_of(int depth) {
  if (depth == CV_32F || depth == CV_64F) return SAMPLEFORMAT_IEEEFP;
  return depth == CV_8U || depth == CV_16U ? SAMPLEFORMAT_UINT : SAMPLEFORMAT_INT;
}

void write_tags(TIFF* tiff, const std::vector<cv::Mat>& bands, const TiffStyle& style) {
  const cv::Mat& first = bands.front();
  const bool is_colour = bands.size() > 2;
  const int plain = style.white_is_zero ? PHOTOMETRIC_MINISWHITE : PHOTOMETRIC_MINISBLACK;
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, first.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, first.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * first.elemSize1()));
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format_of(first.depth()));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(bands.size()));
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, is_colour ? PHOTOMETRIC_RGB : plain);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION,
               style.compressed ? COMPRESSION_ADOBE_DEFLATE : COMPRESSION_NONE);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG,
               style.bands_apart ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, style.orientation);
  if (bands.size() % 2 == 0) {
    std::uint16_t kind = style.has_alpha ? EXTRASAMPLE_UNASSALPHA : EXTRASAMPLE_UNSPECIFIED;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
  }
  if (style.tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kStripRows);
  }
  if (style.no_data.empty()) return;
  static char name[] = "GDAL_NODATA";
  const TIFFFieldInfo info{kGdalNoData, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name};
  TIFFMergeFieldInfo(tiff, &info, 1);
  TIFFSetField(tiff, kGdalNoData, style.no_data.c_str());
}

/// Tiles are filled up at the border with what lies there.
void write_tiles(TIFF* tiff, const cv::Mat& pixels, std::uint16_t band) {
  cv::Mat padded;
  cv::copyMakeBorder(pixels, padded, 0, kTile, 0, kTile, cv::BORDER_REPLICATE);
  for (int y = 0; y < pixels.rows; y += kTile) {
    for (int x = 0; x < pixels.cols; x += kTile) {
      cv::Mat tile = padded(cv::Rect(x, y, kTile, kTile)).clone();
      REQUIRE(TIFFWriteTile(tiff, tile.data, static_cast<std::uint32_t>(x),
                            static_cast<std::uint32_t>(y), 0, band) > 0);
    }
  }
}

void write_rows(TIFF* tiff, const cv::Mat& pixels, std::uint16_t band) {
  for (int y = 0; y < pixels.rows; ++y) {
    cv::Mat row = pixels.row(y).clone();
    REQUIRE(TIFFWriteScanline(tiff, row.data, static_cast<std::uint32_t>(y), band) == 1);
  }
}

}  // namespace

void write_tiff(const std::string& file, const std::vector<cv::Mat>& bands,
                const TiffStyle& style) {
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), style.big ? "w8" : "w"),
                                                    TIFFClose);
  REQUIRE(tiff != nullptr);
  write_tags(tiff.get(), bands, style);
  cv::Mat together;
  cv::merge(bands, together);
  const auto parts = style.bands_apart ? bands : std::vector<cv::Mat>{together};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto write = style.tiled ? write_tiles : write_rows;
    write(tiff.get(), parts[i], static_cast<std::uint16_t>(i));
  }
}

}  // namespace xgm::testing
