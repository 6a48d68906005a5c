// SPDX-License-Identifier: Apache-2.0
// The census transform, eight neighbours at a time, so that the inner loop runs along the row.
#include "plugins/cost/census/transform.hpp"

#include <algorithm>
#include <limits>

#include "plugins/cost/census/compare.hpp"

namespace xgm::census {
namespace {

// Brighter than any centre: what does not exist sets no bit.
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// The rows around row y of one channel, kNothing where there is no pixel.
class Neighbourhood {
 public:
  Neighbourhood(const Image& image, int y, cv::Size window, bool mirrored)
      : image_(image),
        y_(y),
        radius_(window.width / 2, window.height / 2),
        mirrored_(mirrored),
        stride_(static_cast<std::size_t>(image.size().width + window.width)),
        levels_(stride_ * static_cast<std::size_t>(window.height + 1), kNothing) {}

  void load(const cv::Mat1f& plane) {
    const int first = std::max(0, y_ - radius_.y);
    const int last = std::min(plane.rows - 1, y_ + radius_.y);
    for (int row = first; row <= last; ++row) load_row(plane[row], row);
  }

  /// Grey level of the neighbour that pixel 0 has at this offset in the image.
  const float* at(int dx, int dy) const { return pixel(dy + radius_.y) + (mirrored_ ? -dx : dx); }
  /// A neighbour that does not exist.
  const float* nothing() const { return pixel(2 * radius_.y + 1); }

 private:
  void load_row(const float* source, int row) {
    const int width = image_.size().width;
    float* const levels = levels_.data() + offset(row - y_ + radius_.y);
    if (image_.valid.empty()) {
      std::copy_n(source, width, levels);
    } else {
      const std::uint8_t* const valid = image_.valid[row];
      for (int x = 0; x < width; ++x) {
        const float level = source[x];
        levels[x] = valid[x] != 0 ? level : kNothing;
      }
    }
    if (mirrored_) std::reverse(levels, levels + width);
  }
  const float* pixel(int row) const { return levels_.data() + offset(row); }
  std::size_t offset(int row) const {
    return static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(radius_.x);
  }

  const Image& image_;
  int y_;
  cv::Point radius_;
  bool mirrored_;
  std::size_t stride_;
  std::vector<float> levels_;
};

std::vector<Neighbours> neighbours(const Neighbourhood& around, cv::Size window) {
  std::vector<Neighbours> result;
  int bit = 0;
  for (int dy = -(window.height / 2); dy <= window.height / 2; ++dy) {
    for (int dx = -(window.width / 2); dx <= window.width / 2; ++dx) {
      if (dx == 0 && dy == 0) continue;
      if (bit % 8 == 0) result.emplace_back().fill(around.nothing());
      result.back()[static_cast<std::size_t>(bit++ % 8)] = around.at(dx, dy);
    }
  }
  return result;
}

}  // namespace

Descriptors transform(const Image& image, int y, cv::Size window, const cost::RowLayout& layout) {
  Neighbourhood around(image, y, window, layout.mirrored);
  const std::vector<Neighbours> bytes = neighbours(around, window);
  Descriptors row(image, y, static_cast<int>(image.planes.size() * bytes.size()), layout);
  int k = 0;
  for (const cv::Mat1f& plane : image.planes) {
    around.load(plane);
    for (const Neighbours& byte : bytes) compare(byte, around.at(0, 0), plane.cols, row.plane(k++));
  }
  return row;
}

}  // namespace xgm::census
