// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/image_parts.hpp"

#include <algorithm>

namespace xgm {
namespace {

/// Where parts of about the same length begin, and the end.
std::vector<int> cuts(int length, int longest, int alignment) {
  const int steps = (length + alignment - 1) / alignment;
  const int steps_of_part = std::max(1, longest / alignment);
  const int parts = (steps + steps_of_part - 1) / steps_of_part;
  std::vector<int> places;
  for (int k = 0; k <= parts; ++k) {
    const auto step = static_cast<int>(std::int64_t{steps} * k / parts);
    places.push_back(std::min(length, step * alignment));
  }
  return places;
}

}  // namespace

std::vector<cv::Rect> image_parts(cv::Size image, cv::Size largest, int alignment) {
  const std::vector<int> columns = cuts(image.width, largest.width, alignment);
  const std::vector<int> rows = cuts(image.height, largest.height, alignment);
  std::vector<cv::Rect> all;
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      all.emplace_back(cv::Point(columns[i], rows[j]), cv::Point(columns[i + 1], rows[j + 1]));
    }
  }
  return all;
}

std::vector<cv::Rect> row_bands(cv::Size image, int alignment) {
  // Files are decoded in tiles, of which these rows are a multiple nearly always.
  constexpr int kTileRows = 256, kPixels = 1 << 20, kWide = kPixels / kTileRows * 8;
  int rows = kPixels / std::max(1, image.width);
  if (image.width <= kWide) rows = std::max(kTileRows, rows / kTileRows * kTileRows);
  rows = std::max(alignment, rows / alignment * alignment);
  std::vector<cv::Rect> bands;
  for (int y = 0; y < image.height; y += rows) {
    bands.emplace_back(0, y, image.width, std::min(rows, image.height - y));
  }
  return bands;
}

}  // namespace xgm
