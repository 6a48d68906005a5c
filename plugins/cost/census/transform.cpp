// SPDX-License-Identifier: Apache-2.0
// The census transform, offset by offset, so that the inner loop runs along the row.
#include "plugins/cost/census/transform.hpp"

#include <algorithm>
#include <limits>

namespace xgm::census {
namespace {

// Brighter than any centre: what does not exist sets no bit.
constexpr float kNothing = std::numeric_limits<float>::infinity();

// Row y of a plane with `margin` pixels more on each side, kNothing where there is no pixel.
void load_row(const Image& image, const cv::Mat1f& plane, int y, int margin,
              std::vector<float>& row) {
  row.assign(static_cast<std::size_t>(plane.cols + 2 * margin), kNothing);
  if (y < 0 || y >= plane.rows) return;
  for (int x = 0; x < plane.cols; ++x) {
    if (image.is_valid(y, x)) row[static_cast<std::size_t>(x + margin)] = plane(y, x);
  }
}

void append_bit(const float* neighbours, const float* centres, int bit, Descriptors& row) {
  std::uint64_t* const word = row.word(bit / 64);
  const int shift = bit % 64;
  for (int x = 0; x < row.width; ++x) {
    word[x] |= static_cast<std::uint64_t>(neighbours[x] < centres[x]) << shift;
  }
}

}  // namespace

Descriptors transform(const Image& image, int y, cv::Size window) {
  Descriptors row;
  row.width = image.size().width;
  row.channels = static_cast<int>(image.planes.size());
  row.word_count = (row.channels * (window.area() - 1) + 63) / 64;
  row.words.assign(static_cast<std::size_t>(row.word_count) * static_cast<std::size_t>(row.width),
                   0);

  const int radius_x = window.width / 2;
  const int radius_y = window.height / 2;
  std::vector<float> neighbours;
  int bit = 0;
  for (const cv::Mat1f& plane : image.planes) {
    for (int dy = -radius_y; dy <= radius_y; ++dy) {
      load_row(image, plane, y + dy, radius_x, neighbours);
      for (int dx = -radius_x; dx <= radius_x; ++dx) {
        if (dx == 0 && dy == 0) continue;
        append_bit(neighbours.data() + radius_x + dx, plane[y], bit++, row);
      }
    }
  }
  return row;
}

Descriptors mirrored(Descriptors row) {
  for (int k = 0; k < row.word_count; ++k) std::reverse(row.word(k), row.word(k) + row.width);
  return row;
}

}  // namespace xgm::census
