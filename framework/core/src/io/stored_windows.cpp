// SPDX-License-Identifier: Apache-2.0
#include "io/stored_windows.hpp"

#include "io/tiff.hpp"
#include "xgm/io/file.hpp"

namespace xgm {

StoredImage StoredWhole::read(const cv::Rect& window) {
  StoredImage part;
  part.no_data = image_.no_data;
  for (const cv::Mat& channel : image_.channels) part.channels.push_back(channel(window).clone());
  if (!image_.alpha.empty()) part.alpha = image_.alpha(window).clone();
  return part;
}

double StoredWhole::held_bytes() const {
  double bytes = static_cast<double>(image_.alpha.total() * image_.alpha.elemSize());
  for (const cv::Mat& channel : image_.channels) {
    bytes += static_cast<double>(channel.total() * channel.elemSize());
  }
  return bytes;
}

std::unique_ptr<StoredWindows> open_stored(const std::string& file, const std::string& scratch) {
  const std::string head = read_head(file, 8);
  std::unique_ptr<StoredWindows> windows;
  if (is_tiff(head)) windows = open_tiff(file);
  if (head.starts_with("\x89PNG")) windows = open_png(file, scratch);
  if (windows) return windows;
  return std::make_unique<StoredWhole>(read_stored(file));
}

}  // namespace xgm
