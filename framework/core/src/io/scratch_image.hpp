// SPDX-License-Identifier: Apache-2.0
// Decoded rows of an image in a file that ends with its reader: for formats that know no windows.
#pragma once

#include <fstream>

#include "io/stored_windows.hpp"
#include "io/unfinished_file.hpp"

namespace xgm {

class ScratchImage final : public StoredWindows {
 public:
  /// `type`: OpenCV's, of pixels whose bands lie together: grey, blue-green-red, or these and
  /// alpha. Throws Error if no file can be made in the folder.
  ScratchImage(const std::string& folder, cv::Size size, int type);

  /// The next row, from the top.
  void append(const unsigned char* row);
  /// How many there are, which may be read when they are finished.
  int rows() const { return rows_; }
  /// Throws Error if they could not be written. More may follow.
  void finish();

  cv::Size size() const override { return size_; }
  StoredImage read(const cv::Rect& window) override;

 private:
  std::size_t row_bytes() const;

  std::string name_;  ///< for messages
  cv::Size size_;
  int type_;
  int rows_ = 0;
  UnfinishedFile file_;
  std::fstream stream_;
};

}  // namespace xgm
