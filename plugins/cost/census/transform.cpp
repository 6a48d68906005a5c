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

/// The levels of one channel around some pixels of a row.
class Surroundings {
 public:
  Surroundings(cv::Size window, int width)
      : radius_(window.width / 2, window.height / 2),
        nothing_(static_cast<std::size_t>(width + 2 * radius_.x), kNothing) {}

  /// Looks at them where they are: no neighbour must lie beyond an end of the row.
  void view(const cv::Mat1f& plane, int y, cv::Range pixels) {
    lines_.assign(static_cast<std::size_t>(2 * radius_.y + 1), nothing());
    for (int row = first_row(y); row <= last_row(plane, y); ++row)
      line(row - y) = plane[row] + pixels.start;
  }

  /// Copies them, so that there is something where nothing exists, too.
  void copy(const cv::Mat1f& plane, const cv::Mat1b& valid, int y, cv::Range pixels) {
    lines_.assign(static_cast<std::size_t>(2 * radius_.y + 1), nothing());
    const auto stride = static_cast<std::size_t>(pixels.size() + 2 * radius_.x);
    copies_.assign(stride * lines_.size(), kNothing);
    const int first = std::max(0, pixels.start - radius_.x);
    const int last = std::min(plane.cols, pixels.end + radius_.x);
    for (int row = first_row(y); row <= last_row(plane, y); ++row) {
      const auto index = static_cast<std::size_t>(row - y + radius_.y);
      float* const levels = copies_.data() + stride * index + radius_.x;
      const float* const source = plane[row];
      const std::uint8_t* const usable = valid.empty() ? nullptr : valid[row];
      for (int x = first; x < last; ++x) {
        if (usable == nullptr || usable[x] != 0) levels[x - pixels.start] = source[x];
      }
      line(row - y) = levels;
    }
  }

  /// The neighbour that the first pixel has at this offset; those of the next pixels follow.
  const float* at(int dx, int dy) const {
    return lines_[static_cast<std::size_t>(dy + radius_.y)] + dx;
  }
  /// One that does not exist.
  const float* nothing() const { return nothing_.data() + radius_.x; }

 private:
  int first_row(int y) const { return std::max(0, y - radius_.y); }
  int last_row(const cv::Mat1f& plane, int y) const {
    return std::min(plane.rows - 1, y + radius_.y);
  }
  const float*& line(int dy) { return lines_[static_cast<std::size_t>(dy + radius_.y)]; }

  cv::Point radius_;
  std::vector<float> nothing_, copies_;
  std::vector<const float*> lines_;
};

std::vector<Neighbours> neighbours(const Surroundings& around, cv::Size window) {
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
  const int width = image.size().width, radius = window.width / 2;
  const int bytes_of_plane = (window.area() - 1 + 7) / 8;
  Descriptors row(image, y, static_cast<int>(image.planes.size()) * bytes_of_plane, layout);
  Surroundings around(window, width);
  int k = 0;
  const auto describe = [&](cv::Range pixels) {
    const int first = layout.mirrored ? width - 1 - pixels.start : pixels.start;
    int byte = k;
    for (const Neighbours& eight : neighbours(around, window))
      compare(eight, around.at(0, 0), pixels.size(), layout.mirrored, row.plane(byte++) + first);
  };
  // What can be looked at without copying: all but the ends of the row.
  const bool copied = !image.valid.empty() || width <= 2 * radius;
  const cv::Range inside = copied ? cv::Range(width, width) : cv::Range(radius, width - radius);
  for (const cv::Mat1f& plane : image.planes) {
    if (!copied) {
      around.view(plane, y, inside);
      describe(inside);
    }
    for (const cv::Range ends : {cv::Range(0, inside.start), cv::Range(inside.end, width)}) {
      if (ends.empty()) continue;
      around.copy(plane, image.valid, y, ends);
      describe(ends);
    }
    k += bytes_of_plane;
  }
  return row;
}

}  // namespace xgm::census
