// SPDX-License-Identifier: Apache-2.0
// Percentiles in strips of columns, narrow enough that their histograms stay in the caches.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plugins/search_range/window_statistics/ranked_windows.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

constexpr int kStrip = 128;                  // columns answered together
constexpr int kSegment = 16;                 // codes counted as one in the coarse level
constexpr std::size_t kMaxBytes = 16 << 20;  // of the histograms of a strip

using Count = std::uint16_t;  // of up to 255 * 255 pixels

int segments_of(const CodedMap& map) {
  return (static_cast<int>(map.codes.size()) + kSegment - 1) / kSegment;
}

/// into += of, or into -= of.
void add(Count* into, const Count* of, int n) {
  for (int i = 0; i < n; ++i) into[i] = static_cast<Count>(into[i] + of[i]);
}
void remove(Count* from, const Count* what, int n) {
  for (int i = 0; i < n; ++i) from[i] = static_cast<Count>(from[i] - what[i]);
}

/// The histograms of columns [0, columns) of a strip.
class Columns {
 public:
  Columns(int columns, int segments)
      : columns_(columns),
        segments_(segments),
        coarse_(size(columns) * size(segments)),
        fine_(size(columns) * size(segments) * kSegment),
        total_(size(columns)) {}

  int segments() const { return segments_; }
  const Count* coarse(int column) const { return &coarse_[size(column) * size(segments_)]; }
  /// The counts of the codes of one segment.
  const Count* fine(int column, int segment) const { return &fine_[place(column, segment)]; }
  int total(int column) const { return total_[size(column)]; }

  /// Counts a row of indices, one per column; times is 1 or -1.
  void count(const int* indices, int times) {
    for (int column = 0; column < columns_; ++column) {
      if (indices[column] < 0) continue;
      const int segment = indices[column] / kSegment;
      Count& coarse = coarse_[size(column) * size(segments_) + size(segment)];
      Count& fine = fine_[place(column, segment) + size(indices[column] % kSegment)];
      coarse = static_cast<Count>(coarse + times);
      fine = static_cast<Count>(fine + times);
      total_[size(column)] += times;
    }
  }

 private:
  static std::size_t size(int n) { return static_cast<std::size_t>(n); }
  /// Of one segment the columns lie side by side, for windows read few segments.
  std::size_t place(int column, int segment) const {
    return (size(segment) * size(columns_) + size(column)) * kSegment;
  }

  int columns_, segments_;
  std::vector<Count> coarse_, fine_;
  std::vector<int> total_;
};

/// The histogram of a window, the sum of those of columns [begin, end); both only grow.
class Window {
 public:
  explicit Window(const Columns& columns)
      : columns_(columns),
        coarse_(static_cast<std::size_t>(columns.segments())),
        fine_(static_cast<std::size_t>(columns.segments())) {}

  /// To be called first in each row.
  void restart() {
    begin_ = end_ = total_ = 0;
    std::fill(coarse_.begin(), coarse_.end(), Count{0});
    std::fill(fine_.begin(), fine_.end(), Segment{});
  }
  void move(int begin, int end) {
    for (; end_ < end; ++end_) {
      add(coarse_.data(), columns_.coarse(end_), columns_.segments());
      total_ += columns_.total(end_);
    }
    for (; begin_ < begin; ++begin_) {
      remove(coarse_.data(), columns_.coarse(begin_), columns_.segments());
      total_ -= columns_.total(begin_);
    }
  }
  int total() const { return total_; }

  /// Where a search in ascending order has come to.
  struct Place {
    int segment = 0;
    int below = 0;  ///< how many values lie in smaller segments
  };
  /// The index of rank number `rank`, from 1 to total(), not below that of `from`, which moves on.
  int find(int rank, Place& from) {
    for (int count; from.below + (count = coarse_[at(from.segment)]) < rank; ++from.segment) {
      from.below += count;
    }
    const Count* counts = refreshed(from.segment).counts.data();
    int i = 0;
    for (int below = from.below + counts[0]; below < rank; below += counts[++i]) {
    }
    return from.segment * kSegment + i;
  }

 private:
  /// The fine counts of the columns that were the window when it was last read.
  struct Segment {
    std::array<Count, kSegment> counts{};
    int begin = 0, end = 0;
  };

  static std::size_t at(int segment) { return static_cast<std::size_t>(segment); }
  const Segment& refreshed(int segment) {
    Segment& fine = fine_[at(segment)];
    if (begin_ - fine.begin + end_ - fine.end >= end_ - begin_) fine = {{}, begin_, begin_};
    for (; fine.end < end_; ++fine.end) {
      add(fine.counts.data(), columns_.fine(fine.end, segment), kSegment);
    }
    for (; fine.begin < begin_; ++fine.begin) {
      remove(fine.counts.data(), columns_.fine(fine.begin, segment), kSegment);
    }
    return fine;
  }

  const Columns& columns_;
  std::vector<Count> coarse_;
  std::vector<Segment> fine_;
  int begin_ = 0, end_ = 0, total_ = 0;
};

/// The rank of a percentile by the number of values.
std::vector<int> ranks(double percentile, int most) {
  std::vector<int> rank;
  for (int total = 0; total <= most; ++total) {
    rank.push_back(RankedWindows::rank(percentile, total));
  }
  return rank;
}

struct Ranks {
  std::vector<int> low, high;
};

void rank_strip(const RankedWindows& windows, const Ranks& ranks, cv::Range strip) {
  const cv::Mat1i& index = windows.map.index;
  const int radius = windows.radius;
  const cv::Range seen(std::max(0, strip.start - radius), std::min(index.cols, strip.end + radius));
  Columns columns(seen.size(), segments_of(windows.map));
  Window window(columns);
  for (int y = 0; y < std::min(radius, index.rows); ++y) columns.count(index[y] + seen.start, 1);
  for (int y = 0; y < index.rows; ++y) {
    if (y + radius < index.rows) columns.count(index[y + radius] + seen.start, 1);
    if (y - radius > 0) columns.count(index[y - radius - 1] + seen.start, -1);
    window.restart();
    for (int x = strip.start; x < strip.end; ++x) {
      window.move(std::max(seen.start, x - radius) - seen.start,
                  std::min(seen.end, x + radius + 1) - seen.start);
      if (windows.asked(y, x) == 0 || window.total() == 0) continue;
      const auto total = static_cast<std::size_t>(window.total());
      Window::Place place;
      const int low = window.find(ranks.low[total], place);
      windows.answer(y, x, low, window.find(ranks.high[total], place));
    }
  }
}

}  // namespace

bool columns_fit(const RankedWindows& windows) {
  const auto columns = static_cast<std::size_t>(kStrip + 2 * windows.radius);
  const auto codes = static_cast<std::size_t>(segments_of(windows.map)) * kSegment;
  return columns * codes * sizeof(Count) <= kMaxBytes;
}

void rank_by_columns(const RankedWindows& windows) {
  const int side = 2 * windows.radius + 1, cols = windows.map.index.cols;
  const Ranks by_total{ranks(windows.percentiles.low, side * side),
                       ranks(windows.percentiles.high, side * side)};
  parallel_for(0, (cols + kStrip - 1) / kStrip, [&](int i) {
    rank_strip(windows, by_total, {i * kStrip, std::min(cols, (i + 1) * kStrip)});
  });
}

}  // namespace xgm::search_range
