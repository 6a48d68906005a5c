// SPDX-License-Identifier: Apache-2.0
// A ring of the path costs of the last few lines of a pass: all that later pixels read.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "plugins/aggregation/path_engine/line_layout.hpp"
#include "plugins/aggregation/path_engine/pass.hpp"
#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// How the path costs of a line lie in memory: for each path, the slices of all pixels one behind
/// the other, with a margin before each. The granule behind a slice is filled with infinite costs
/// when the slice is written, so that every slice has infinite costs on both sides.
class PathLayout {
 public:
  PathLayout(const VolumeShape& shape, int bytes_of_cell) : margin_(VolumeShape::kGranule) {
    // In dense volumes slices lie at the same places in every line, so margins stay infinite. If
    // slices are long, margins of a cache line are affordable, and keep slices aligned to them.
    const int cache_line = static_cast<int>(kBufferAlignment) / bytes_of_cell;
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
  /// From the first cell of a slice of `room` cells to that of the next slice.
  int stride(int room) const {
    return room == 0 ? 0 : ((room + margin_ - 1) & -margin_) + margin_;  // a power of two
  }
  /// Cells that one path needs for the longest slice, and for the fullest row or column.
  std::size_t longest() const { return static_cast<std::size_t>(longest_); }
  std::size_t fullest_line(bool row) const { return row ? fullest_row_ : fullest_column_; }

 private:
  int margin_, longest_;
  std::size_t fullest_row_ = 0, fullest_column_ = 0;
};

/// How many lines of path costs a pass keeps, and how much of each.
struct LinesKept {
  int bands = 0;       ///< bands in the ring
  int band_lines = 0;  ///< lines of each band
  int last_lines = 0;  ///< last lines of a band, kept whole because the next band reads them
  int pixels = 0;      ///< pixels kept of each other line
};

/// What is known of the pixels of a line, an array per property. A pixel that was never opened
/// stands for one that does not exist; kBeside such pixels follow both ends of the line.
template <class Cell>
struct LinePixels {
  /// Disparities from..to have path costs in memory, infinite ones where there is no match. The
  /// path cost of disparity d is cell zero + d of the line.
  int *from, *to, *zero;
  Repeated*
      minimum;  ///< min_i L(p, i) of each path, `paths` per pixel; infinite if the pixel is lost
  int paths;    ///< number of paths
  std::uint8_t* lost;  ///< 1 if no disparity can be matched, else 0; set if paths have two terms
  std::atomic<bool>* any_lost;  ///< whether a pixel of the line that has cells is lost

  /// The same arrays with pixel u as element 0.
  LinePixels at(std::ptrdiff_t u) const {
    return {from + u, to + u, zero + u, minimum + u * paths, paths, lost + u, any_lost};
  }
  void lose(int u) const {
    lost[u] = 1;
    any_lost->store(true, std::memory_order_relaxed);
  }
};

/// A ring of lines. Each pixel takes as many cells as it needs, so that a line of a ragged volume
/// needs no more memory than the fullest line has cells.
template <class Cell>
class PathLines {
 public:
  using Pixels = LinePixels<Cell>;

  PathLines(const PathLayout& layout, const PassFrame& frame, int paths, const LinesKept& kept)
      : layout_(layout), lines_(static_cast<std::size_t>(kept.bands * kept.band_lines)) {
    const auto padded = static_cast<std::size_t>(frame.length() + 2 * kBeside);
    const std::size_t whole = layout.fullest_line(frame.lines_are_rows());
    const std::size_t part =
        std::min(whole, layout.longest() * static_cast<std::size_t>(kept.pixels));
    nothing_.resize(padded, paths);
    for (int i = 0; i < slots(); ++i) {
      const bool is_whole = i % kept.band_lines >= kept.band_lines - kept.last_lines;
      Line& line = lines_[static_cast<std::size_t>(i)];
      line.resize(padded, paths);
      line.cells = (is_whole ? whole : part) + static_cast<std::size_t>(layout.margin());
      line.stride = line.cells + kBehind;
      const std::size_t all = line.stride * static_cast<std::size_t>(paths);
      line.memory = new_buffer(all * sizeof(Cell));
      std::fill_n(static_cast<Cell*>(line.memory.get()), all, kInfinite<Cell>);
    }
  }

  int slots() const { return static_cast<int>(lines_.size()); }
  int slot(int v) const { return v % slots(); }

  /// The pixels of line v, pixel 0 first. Line v takes the slot of line v - slots(). Lines before
  /// the first one have no pixels.
  Pixels pixels(int v) { return (v < 0 ? nothing_ : line_of(v)).pixels(); }
  /// Path costs of a path in line v; null before the first line. Up to kBehind cells behind a slice
  /// may be read, and written until the slice of the next pixel is written.
  Cell* costs(int v, int path) {
    if (v < 0) return nullptr;
    Line& line = line_of(v);
    return static_cast<Cell*>(line.memory.get()) + line.stride * static_cast<std::size_t>(path);
  }

  /// Makes room for elements from..to - 1 of the layout, whose slices are known, in line v. Pixels
  /// are opened in order, from pixel 0 on. If only a part of the line is kept, the room of the
  /// pixels opened first is used again.
  void open(int v, LineLayout& layout, int from, int to) {
    Line& line = line_of(v);
    if (layout.first + from == 0) line.begin(layout_.margin());
    const Pixels pixels = line.pixels().at(layout.first);
    const int cells = static_cast<int>(line.cells), margin = layout_.margin();
    int next = line.next;
    for (int k = from; k < to; ++k) {
      const int begin = layout.begin[k], room = layout.room[k];
      if (room == 0) {
        skip(pixels, k);
        continue;
      }
      const int stride = layout_.stride(room);
      const int first = next + stride > cells ? margin : next;
      next = first + stride;
      pixels.from[k] = begin - VolumeShape::kGranule;
      pixels.to[k] = begin + room + VolumeShape::kGranule - 1;
      pixels.zero[k] = first - begin;
      pixels.lost[k] = 0;
      layout.own[k] = first;
    }
    line.next = next;
  }

 private:
  static constexpr int kNone = 1 << 30;  // far beyond any disparity; arithmetic cannot overflow
  static constexpr int kBeside = kFarthest + LineLayout::kPixels;
  static constexpr std::size_t kBehind = 64;  // the widest vector

  /// Marks a pixel that has no cells.
  static void skip(const Pixels& pixels, int k) {
    pixels.from[k] = kNone;
    pixels.to[k] = -kNone;
    pixels.zero[k] = 0;
    pixels.lost[k] = 1;
    std::fill_n(pixels.minimum + k * pixels.paths, pixels.paths, Repeated(kInfinite<Cell>));
  }

  struct Line {
    AlignedBuffer memory;
    std::size_t cells = 0, stride = 0;  // of each path, without and with kBehind
    int paths = 0;
    int next = 0;  // first cell of the pixel that is opened next
    std::vector<int> from, to, zero;
    std::vector<Repeated> minimum;
    std::vector<std::uint8_t> lost;
    std::atomic<bool> any_lost = false;

    void resize(std::size_t padded, int path_count) {
      paths = path_count;
      from.assign(padded, kNone);
      to.assign(padded, -kNone);
      zero.assign(padded, 0);
      minimum.assign(padded * static_cast<std::size_t>(paths), Repeated(kInfinite<Cell>));
      lost.assign(padded, 1);
    }
    void begin(int margin) {
      next = margin;
      any_lost.store(false, std::memory_order_relaxed);
    }
    Pixels pixels() {
      return Pixels{from.data(), to.data(),   zero.data(), minimum.data(),
                    paths,       lost.data(), &any_lost}
          .at(kBeside);
    }
  };

  Line& line_of(int v) { return lines_[static_cast<std::size_t>(slot(v))]; }

  PathLayout layout_;
  std::vector<Line> lines_;
  Line nothing_;
};

}  // namespace xgm::aggregation
