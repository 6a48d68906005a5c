// SPDX-License-Identifier: Apache-2.0
// Path costs of the last few lines of a pass: all that the recursion looks back at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/aggregation/shared/pass.hpp"
#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/base/cells.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// A ring of lines. The slices of a pixel, one per path, lie one behind the other, with a margin
/// before each: the granule behind a slice is written with it, infinite, so that there is a granule
/// of infinite costs on both sides. Pixels take as many cells as they need, so that ragged volumes
/// need no more room than their fullest line.
template <class Cell>
class PathLines {
 public:
  struct Pixel {
    Cell* cells = nullptr;  ///< L(p, .) of the first path
    int begin = 0;          ///< disparity of the first cell
    int room = 0;           ///< cells of one path
    int stride = 0;         ///< from one path's cells to the next one's
    bool counts = false;    ///< whether a cost is finite
  };

  PathLines(const VolumeShape& shape, const PassFrame& frame, int paths, int ring_lines)
      : paths_(paths), margin_(margin(shape)), lines_(static_cast<std::size_t>(ring_lines)) {
    const std::size_t capacity = most_cells(shape, frame);
    for (Line& line : lines_) {
      line.pixels.resize(static_cast<std::size_t>(frame.length()));
      line.memory = new_cells(capacity * sizeof(Cell));
      std::fill_n(first_cell(line), capacity, kInfinite<Cell>);
    }
  }

  int slots() const { return static_cast<int>(lines_.size()); }
  int slot(int v) const { return v % slots(); }

  /// The pixels of line v, which forgets line v - slots().
  Pixel* line(int v) { return line_of(v).pixels.data(); }

  /// Makes room for pixel u of line v; pixel u - 1 must have been opened.
  Pixel& open(int u, int v, int begin, int room) {
    Line& line = line_of(v);
    Pixel& pixel = line.pixels[static_cast<std::size_t>(u)];
    Cell* cells = first_cell(line) + margin_;
    if (u > 0) cells = (&pixel)[-1].cells + std::ptrdiff_t{(&pixel)[-1].stride} * paths_;
    pixel = {cells, begin, room, room == 0 ? 0 : aligned(room) + margin_, false};
    return pixel;
  }

 private:
  struct Line {
    Cells memory;
    std::vector<Pixel> pixels;
  };

  static Cell* first_cell(const Line& line) { return static_cast<Cell*>(line.memory.get()); }

  Line& line_of(int v) { return lines_[static_cast<std::size_t>(slot(v))]; }

  /// A granule; whole cache lines where slices are long and always lie at the same places, so that
  /// what is between them stays infinite from the beginning.
  static int margin(const VolumeShape& shape) {
    constexpr int kCacheLine = static_cast<int>(kCellAlignment / sizeof(Cell));
    const int room = VolumeShape::rounded_up(shape.max_count());
    const bool dense =
        shape.cells() == std::int64_t{shape.width()} * shape.height() * std::int64_t{room};
    return dense && room >= 2 * kCacheLine ? kCacheLine : VolumeShape::kGranule;
  }
  int aligned(int room) const { return (room + margin_ - 1) & -margin_; }  // a power of two

  /// Cells of all paths in the fullest line.
  std::size_t most_cells(const VolumeShape& shape, const PassFrame& frame) const {
    std::size_t most = 0;
    for (int v = 0; v < frame.lines(); ++v) {
      std::size_t cells = 0;
      for (int u = 0; u < frame.length(); ++u) {
        const cv::Point p = frame.pixel(u, v);
        cells += static_cast<std::size_t>(aligned(shape.room(p.y, p.x)) + margin_);
      }
      most = std::max(most, cells);
    }
    return most * static_cast<std::size_t>(paths_) + 2 * static_cast<std::size_t>(margin_);
  }

  int paths_;
  int margin_;
  std::vector<Line> lines_;
};

}  // namespace xgm::aggregation
