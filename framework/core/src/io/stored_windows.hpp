// SPDX-License-Identifier: Apache-2.0
// An image file that is read by windows, as it is stored.
#pragma once

#include <memory>
#include <string>

#include "io/unscaled_image.hpp"

namespace xgm {

/// One thread at a time may read.
class StoredWindows {
 public:
  virtual ~StoredWindows() = default;
  virtual cv::Size size() const = 0;
  /// The window, which lies within the image, with pixels of its own. Throws Error.
  virtual StoredImage read(const cv::Rect& window) = 0;
  /// Bytes of memory that are held from one window to the next.
  virtual double held_bytes() const { return 0; }
};

/// Held in memory as a whole: what can only be decoded so.
class StoredWhole final : public StoredWindows {
 public:
  explicit StoredWhole(StoredImage image) : image_(std::move(image)) {}
  cv::Size size() const override { return image_.channels.front().size(); }
  StoredImage read(const cv::Rect& window) override;
  double held_bytes() const override;

 private:
  StoredImage image_;
};

/// None if the file is no TIFF that can be read by windows: OpenCV has to decode it (read_tiff()),
/// or its strips or tiles are too large to be decoded one after the other.
std::unique_ptr<StoredWindows> open_tiff(const std::string& file);

/// Decodes a PNG, row by row as far as windows reach, into a file without name in `scratch`, of
/// which they are read. None if it has to be decoded as a whole: interlaced, with a palette, or of
/// less than 8 bits.
std::unique_ptr<StoredWindows> open_png(const std::string& file, const std::string& scratch);

/// Any format. Files that are needed meanwhile are made in the folder `scratch`. Throws Error as
/// read_unscaled() does, for damages of pixels maybe not before these are read.
std::unique_ptr<StoredWindows> open_stored(const std::string& file, const std::string& scratch);

}  // namespace xgm
