// SPDX-License-Identifier: Apache-2.0
// Path costs of the last few lines of a pass: all that the recursion looks back at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/aggregation/shared/pass.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// L(p, d) of one path and pixel.
template <class Cell>
struct PathCosts {
  Cell* cells;  ///< one per disparity of the pixel, with an infinite one on either side
  Cell* least;  ///< min over the pixel; infinite if it has no finite cell
};

/// A ring of lines. Pixels lie one behind the other with as many cells as they need, so that ragged
/// volumes need no more room than their fullest line.
template <class Cell>
class PathLines {
 public:
  PathLines(const VolumeShape& shape, const PassFrame& frame, int paths, int ring_lines,
            Cell infinite)
      : infinite_(infinite), paths_(paths), length_(frame.length()) {
    const std::size_t capacity = most_cells(shape, frame);
    lines_.resize(static_cast<std::size_t>(ring_lines));
    for (Line& line : lines_) {
      line.start.assign(static_cast<std::size_t>(length_) + 1, 0);
      line.cells.resize(capacity * static_cast<std::size_t>(paths));
      line.least.resize(static_cast<std::size_t>(length_) * static_cast<std::size_t>(paths));
    }
  }

  int slots() const { return static_cast<int>(lines_.size()); }
  int slot(int v) const { return v % slots(); }
  Cell infinite() const { return infinite_; }

  /// Makes room for pixel u of line v; pixel u - 1 must have been opened. Forgets line v - slots().
  void open(int u, int v, int count) {
    Line& line = line_of(v);
    const auto i = static_cast<std::size_t>(u);
    const std::size_t padded = static_cast<std::size_t>(count) + 2;
    line.start[i + 1] = line.start[i] + padded * static_cast<std::size_t>(paths_);
    for (int path = 0; path < paths_; ++path) {
      Cell* const cells = costs(u, v, path, count).cells;
      cells[-1] = cells[count] = infinite_;
    }
  }

  /// `count` is the pixel's number of disparities.
  PathCosts<Cell> costs(int u, int v, int path, int count) {
    Line& line = line_of(v);
    const std::size_t padded = static_cast<std::size_t>(count) + 2;
    const std::size_t first =
        line.start[static_cast<std::size_t>(u)] + padded * static_cast<std::size_t>(path) + 1;
    return {line.cells.data() + first, line.least.data() + u * paths_ + path};
  }

 private:
  struct Line {
    std::vector<std::size_t> start;  // per pixel, plus one: first cell of its first path
    std::vector<Cell> cells;
    std::vector<Cell> least;  // per pixel and path
  };

  Line& line_of(int v) { return lines_[static_cast<std::size_t>(slot(v))]; }

  /// Cells of one path in the fullest line.
  static std::size_t most_cells(const VolumeShape& shape, const PassFrame& frame) {
    std::size_t most = 0;
    for (int v = 0; v < frame.lines(); ++v) {
      std::size_t cells = 0;
      for (int u = 0; u < frame.length(); ++u) {
        const cv::Point p = frame.pixel(u, v);
        cells += static_cast<std::size_t>(shape.count(p.y, p.x)) + 2;
      }
      most = std::max(most, cells);
    }
    return most;
  }

  Cell infinite_;
  int paths_;
  int length_;
  std::vector<Line> lines_;
};

}  // namespace xgm::aggregation
