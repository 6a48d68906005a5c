// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "io/tiff_file.hpp"

namespace xgm {
namespace {

/// Reads strip by strip, or tile by tile, those that a window touches.
class BandReader {
 public:
  BandReader(const TiffFile& tiff, const TiffLayout& layout, const cv::Rect& window)
      : tiff_(tiff),
        layout_(layout),
        window_(window),
        chunk_(chunk_of(tiff, layout)),
        buffer_(std::make_unique_for_overwrite<unsigned char[]>(chunk_.bytes)) {}

  std::vector<cv::Mat> read() {
    std::vector<cv::Mat> bands;
    for (int i = 0; i < layout_.samples; ++i) bands.emplace_back(window_.size(), layout_.depth);
    const auto first = [](int at, std::uint32_t side) {
      return static_cast<std::uint32_t>(at) / side * side;
    };
    const auto right = static_cast<std::uint32_t>(window_.br().x);
    const auto bottom = static_cast<std::uint32_t>(window_.br().y);
    for (int band = 0; band < layout_.samples; band += chunk_.bands) {
      for (auto y = first(window_.y, chunk_.rows); y < bottom; y += chunk_.rows) {
        for (auto x = first(window_.x, chunk_.width); x < right; x += chunk_.width) {
          read_chunk(bands, band, x, y);
        }
      }
    }
    return bands;
  }

 private:
  void read_chunk(std::vector<cv::Mat>& bands, int band, std::uint32_t x, std::uint32_t y) {
    const cv::Point corner(static_cast<int>(x), static_cast<int>(y));
    const auto width = static_cast<int>(chunk_.width);
    // The last strip is only as long as the image; tiles are always whole.
    const auto rows = static_cast<int>(
        layout_.is_tiled ? chunk_.rows : std::min(chunk_.rows, layout_.height - y));
    const auto bytes = static_cast<tmsize_t>(chunk_.bytes / chunk_.rows) * rows;
    const auto sample = static_cast<std::uint16_t>(band);
    TIFF* handle = tiff_.handle();
    const tmsize_t got = layout_.is_tiled
                             ? TIFFReadEncodedTile(handle, TIFFComputeTile(handle, x, y, 0, sample),
                                                   buffer_.get(), bytes)
                             : TIFFReadEncodedStrip(handle, TIFFComputeStrip(handle, y, sample),
                                                    buffer_.get(), bytes);
    if (got != bytes) tiff_.fail("is cut short or damaged at row " + std::to_string(y));
    const cv::Mat chunk(rows, width, CV_MAKETYPE(layout_.depth, chunk_.bands), buffer_.get());
    const cv::Rect wanted = cv::Rect(corner, chunk.size()) & window_;
    std::vector<cv::Mat> parts;  // of the bands, where the chunk belongs
    for (int i = band; i < band + chunk_.bands; ++i) {
      parts.push_back(bands[static_cast<std::size_t>(i)](wanted - window_.tl()));
    }
    cv::split(chunk(wanted - corner), parts.data());
  }

  const TiffFile& tiff_;
  const TiffLayout& layout_;
  cv::Rect window_;
  TiffChunk chunk_;
  std::unique_ptr<unsigned char[]> buffer_;
};

}  // namespace

TiffChunk chunk_of(const TiffFile& tiff, const TiffLayout& layout) {
  TiffChunk chunk;
  if (layout.is_tiled) {
    chunk.width = tiff.field(TIFFTAG_TILEWIDTH, std::uint32_t{0});
    chunk.rows = tiff.field(TIFFTAG_TILELENGTH, std::uint32_t{0});
  } else {
    chunk.width = layout.width;
    chunk.rows = std::min(tiff.field(TIFFTAG_ROWSPERSTRIP, layout.height), layout.height);
  }
  chunk.bands = layout.bands_lie_apart ? 1 : layout.samples;
  const std::size_t pixel_bytes =
      CV_ELEM_SIZE1(layout.depth) * static_cast<std::size_t>(chunk.bands);
  tiff.require_possible(chunk.width, chunk.rows, pixel_bytes);
  chunk.bytes = std::size_t{chunk.width} * chunk.rows * pixel_bytes;
  return chunk;
}

std::vector<cv::Mat> read_bands(const TiffFile& tiff, const TiffLayout& layout,
                                const cv::Rect& window) {
  return BandReader(tiff, layout, window).read();
}

}  // namespace xgm
