// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "io/tiff_file.hpp"

namespace xgm {
namespace {

/// Reads strip by strip, or tile by tile.
class BandReader {
 public:
  BandReader(const TiffFile& tiff, const TiffLayout& layout) : tiff_(tiff), layout_(layout) {
    if (layout.is_tiled) {
      width_ = tiff.field(TIFFTAG_TILEWIDTH, std::uint32_t{0});
      rows_ = tiff.field(TIFFTAG_TILELENGTH, std::uint32_t{0});
    } else {
      width_ = layout.width;
      rows_ = std::min(tiff.field(TIFFTAG_ROWSPERSTRIP, layout.height), layout.height);
    }
    together_ = layout.bands_lie_apart ? 1 : layout.samples;
    pixel_bytes_ = CV_ELEM_SIZE1(layout.depth) * static_cast<std::size_t>(together_);
    tiff.require_possible(width_, rows_, pixel_bytes_);
    buffer_ =
        std::make_unique_for_overwrite<unsigned char[]>(std::size_t{width_} * rows_ * pixel_bytes_);
  }

  std::vector<cv::Mat> read() {
    const cv::Size size(static_cast<int>(layout_.width), static_cast<int>(layout_.height));
    std::vector<cv::Mat> bands;
    for (int i = 0; i < layout_.samples; ++i) bands.emplace_back(size, layout_.depth);
    for (int band = 0; band < layout_.samples; band += together_) {
      for (std::uint32_t y = 0; y < layout_.height; y += rows_) {
        for (std::uint32_t x = 0; x < layout_.width; x += width_) {
          read_chunk(bands, band, x, y);
        }
      }
    }
    return bands;
  }

 private:
  void read_chunk(std::vector<cv::Mat>& bands, int band, std::uint32_t x, std::uint32_t y) {
    const auto width = static_cast<int>(width_);
    const cv::Rect area(static_cast<int>(x), static_cast<int>(y),
                        std::min(width, static_cast<int>(layout_.width - x)),
                        static_cast<int>(std::min(rows_, layout_.height - y)));
    // The last strip is only as long as the image; tiles are always whole.
    const auto rows = layout_.is_tiled ? static_cast<int>(rows_) : area.height;
    const auto bytes = static_cast<tmsize_t>(static_cast<std::size_t>(width) *
                                             static_cast<std::size_t>(rows) * pixel_bytes_);
    const auto sample = static_cast<std::uint16_t>(band);
    TIFF* handle = tiff_.handle();
    const tmsize_t got = layout_.is_tiled
                             ? TIFFReadEncodedTile(handle, TIFFComputeTile(handle, x, y, 0, sample),
                                                   buffer_.get(), bytes)
                             : TIFFReadEncodedStrip(handle, TIFFComputeStrip(handle, y, sample),
                                                    buffer_.get(), bytes);
    if (got != bytes) tiff_.fail("is cut short or damaged at row " + std::to_string(y));
    const cv::Mat chunk(rows, width, CV_MAKETYPE(layout_.depth, together_), buffer_.get());
    std::vector<cv::Mat> parts;  // of the bands, where the chunk belongs
    for (int i = band; i < band + together_; ++i) {
      parts.push_back(bands[static_cast<std::size_t>(i)](area));
    }
    cv::split(chunk(cv::Rect(0, 0, area.width, area.height)), parts.data());
  }

  const TiffFile& tiff_;
  const TiffLayout& layout_;
  std::uint32_t width_ = 0, rows_ = 0;  // of a strip or tile
  int together_ = 1;                    // bands in one strip or tile
  std::size_t pixel_bytes_ = 1;
  std::unique_ptr<unsigned char[]> buffer_;
};

}  // namespace

std::vector<cv::Mat> read_bands(const TiffFile& tiff, const TiffLayout& layout) {
  return BandReader(tiff, layout).read();
}

}  // namespace xgm
