// SPDX-License-Identifier: Apache-2.0
// Path costs of the last few lines of a pass: all that the recursion looks back at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "plugins/aggregation/shared/pass.hpp"
#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/base/cells.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// How the path costs of a line lie in memory: for each path the slices of all pixels, one behind
/// the other, with a margin before each. The granule behind a slice is written with it, infinite,
/// so that there is a granule of infinite costs on both sides.
class PathLayout {
 public:
  PathLayout(const VolumeShape& shape, int bytes_of_cell) : margin_(VolumeShape::kGranule) {
    // Whole cache lines where slices are long and always lie at the same places, so that what is
    // between them stays infinite from the beginning.
    const int cache_line = static_cast<int>(kCellAlignment) / bytes_of_cell;
    const int room = VolumeShape::rounded_up(shape.max_count());
    const bool dense =
        shape.cells() == std::int64_t{shape.width()} * shape.height() * std::int64_t{room};
    if (dense && room >= 2 * cache_line) margin_ = cache_line;
    longest_ = stride(room);
    std::vector<std::size_t> columns(static_cast<std::size_t>(shape.width()));
    for (int y = 0; y < shape.height(); ++y) {
      std::size_t row = 0;
      for (int x = 0; x < shape.width(); ++x) {
        const auto cells = static_cast<std::size_t>(stride(shape.room(y, x)));
        row += cells;
        columns[static_cast<std::size_t>(x)] += cells;
      }
      fullest_row_ = std::max(fullest_row_, row);
    }
    fullest_column_ = *std::ranges::max_element(columns);
  }

  int margin() const { return margin_; }
  /// From one path's cells to the next one's.
  int stride(int room) const {
    return room == 0 ? 0 : ((room + margin_ - 1) & -margin_) + margin_;  // a power of two
  }
  /// Cells of one path: of the longest slice, and of all slices of the fullest row or column.
  std::size_t longest() const { return static_cast<std::size_t>(longest_); }
  std::size_t fullest_line(bool row) const { return row ? fullest_row_ : fullest_column_; }

 private:
  int margin_, longest_;
  std::size_t fullest_row_ = 0, fullest_column_ = 0;
};

/// Which lines of a pass are kept, and how much of each.
struct LinesKept {
  int bands = 0;       ///< lines come in bands...
  int band_lines = 0;  ///< of so many...
  int last_lines = 0;  ///< of which the last ones are kept whole, for the next band,
  int pixels = 0;      ///< and only so many pixels of the others
};

/// A ring of lines. Pixels take as many cells as they need, so that ragged volumes need no more
/// room than their fullest line.
template <class Cell>
class PathLines {
 public:
  /// One that was never opened stands for what does not exist.
  struct Pixel {
    /// Disparities from..to have path costs in memory, those without a match infinite ones; that of
    /// disparity d is cell zero + d of a line of costs.
    int from = kNone, to = -kNone;
    int zero = 0;
    int next = 0;            ///< cell behind its margin
    Cell least[kMostPaths];  ///< min_i L(p, i) of each path, infinite if there is no match at all

    Pixel() { std::fill_n(least, kMostPaths, kInfinite<Cell>); }
    bool counts() const { return least[0] != kInfinite<Cell>; }
  };

  PathLines(const PathLayout& layout, const PassFrame& frame, int paths, const LinesKept& kept)
      : layout_(layout), lines_(static_cast<std::size_t>(kept.bands * kept.band_lines)) {
    const auto padded = static_cast<std::size_t>(frame.length() + 2 * kFarthest);
    const std::size_t whole = layout.fullest_line(frame.lines_are_rows());
    const std::size_t part =
        std::min(whole, layout.longest() * static_cast<std::size_t>(kept.pixels));
    nothing_.resize(padded);
    for (int i = 0; i < slots(); ++i) {
      const bool is_whole = i % kept.band_lines >= kept.band_lines - kept.last_lines;
      Line& line = lines_[static_cast<std::size_t>(i)];
      line.pixels.resize(padded);
      line.pixels[kFarthest - 1].next = layout.margin();
      line.cells = (is_whole ? whole : part) + static_cast<std::size_t>(layout.margin());
      const std::size_t all = line.cells * static_cast<std::size_t>(paths);
      line.memory = new_cells(all * sizeof(Cell));
      std::fill_n(static_cast<Cell*>(line.memory.get()), all, kInfinite<Cell>);
    }
  }

  int slots() const { return static_cast<int>(lines_.size()); }
  int slot(int v) const { return v % slots(); }

  /// The pixels of line v, which forgets line v - slots(). Beyond both ends, and before the first
  /// line, there are kFarthest pixels that do not exist.
  Pixel* line(int v) { return (v < 0 ? nothing_ : line_of(v).pixels).data() + kFarthest; }
  /// L(., .) of a path in line v.
  Cell* costs(int v, int path) {
    if (v < 0) return nullptr;
    Line& line = line_of(v);
    return static_cast<Cell*>(line.memory.get()) + line.cells * static_cast<std::size_t>(path);
  }

  /// Of each path, in line v.
  int cells(int v) { return static_cast<int>(line_of(v).cells); }

  /// Makes room for a pixel of a line of so many cells; the one before it must have been opened.
  /// Where only a part of the line is kept, the pixels opened first are forgotten.
  void open(Pixel& pixel, int cells, int begin, int room) const {
    const int stride = layout_.stride(room);
    int first = (&pixel)[-1].next;
    if (first + stride > cells) first = layout_.margin();
    pixel.from = begin - VolumeShape::kGranule;
    pixel.to = begin + room + VolumeShape::kGranule - 1;
    pixel.zero = first - begin;
    pixel.next = first + stride;
  }

  /// A pixel of no cells.
  void skip(Pixel& pixel) const {
    pixel = {};
    pixel.next = (&pixel)[-1].next;
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::max();

  struct Line {
    Cells memory;
    std::size_t cells = 0;  // of each path
    std::vector<Pixel> pixels;
  };

  Line& line_of(int v) { return lines_[static_cast<std::size_t>(slot(v))]; }

  PathLayout layout_;
  std::vector<Line> lines_;
  std::vector<Pixel> nothing_;
};

}  // namespace xgm::aggregation
