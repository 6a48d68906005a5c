// SPDX-License-Identifier: Apache-2.0
// A TIFF that is open, and its bands.
#pragma once

#include <tiffio.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace xgm {

/// An open file. Its handlers are its own: libtiff's, of the whole process, are left alone.
class TiffFile {
 public:
  /// Throws Error.
  explicit TiffFile(const std::string& name);
  ~TiffFile();
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  const std::string& name() const { return name_; }
  TIFF* handle() const { return handle_; }

  template <class Value>
  Value field(ttag_t tag, Value otherwise) const {
    Value value{};
    return TIFFGetFieldDefaulted(handle_, tag, &value) == 1 ? value : otherwise;
  }

  /// Throws Error with what libtiff said last.
  [[noreturn]] void fail(const std::string& what) const;
  /// Throws Error if an image or a tile cannot have this size and so many bytes in a pixel.
  void require_possible(std::uint32_t width, std::uint32_t height, std::size_t pixel_bytes) const;

 private:
  std::string name_;
  std::string message_{};
  TIFF* handle_ = nullptr;
};

/// How the samples of an image lie in its file.
struct TiffLayout {
  std::uint32_t width = 0, height = 0;
  int samples = 1;
  int depth = -1;  ///< OpenCV's code, -1 if samples are not plain numbers
  bool is_tiled = false;
  bool bands_lie_apart = false;
};

/// A strip or tile, which is decoded as a whole.
struct TiffChunk {
  std::uint32_t width = 0, rows = 0;
  int bands = 1;  ///< that lie in it together
  std::size_t bytes = 0;
};
/// The layout has a depth. Throws Error.
TiffChunk chunk_of(const TiffFile& tiff, const TiffLayout& layout);

/// A window of the bands, in the order of the file, not turned. The layout has a depth. Throws
/// Error.
std::vector<cv::Mat> read_bands(const TiffFile& tiff, const TiffLayout& layout,
                                const cv::Rect& window);

}  // namespace xgm
