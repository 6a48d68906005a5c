// SPDX-License-Identifier: Apache-2.0
// A pass over a volume as seen from a pixel: where its cells are, and what its paths look back at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "plugins/aggregation/shared/pass.hpp"
#include "plugins/aggregation/shared/pass_penalties.hpp"
#include "plugins/aggregation/shared/path_lines.hpp"
#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// Lines that a thread walks along at once, a pixel of each in turn. A path along the line has to
/// wait for its least cost at one pixel before the next; meanwhile the other lines advance.
inline constexpr int kBand = 4;

/// What path costs a pass keeps when so many threads walk.
LinesKept lines_kept(const Pass& pass, int lines, int threads);

/// A line that is being walked along.
template <class Cell>
struct WalkedLine {
  int v;
  const typename PathLines<Cell>::Pixel* back[kMostSteps];  ///< back[t][u]: p - x of step t
  const Cell* back_costs[kMostSteps];                       ///< of its line and path
  Cell* costs[kMostPaths];                                  ///< of this line
  const Cell *p1[kMostSteps], *p2[kMostSteps];              ///< of each step, by match class
  int base_classes;  ///< those that p1 and p2 belong to, if packed; else -1
  int penalty_slot;  ///< -1: that of the image row
  Cell* scratch;     ///< a slice per step, should it have to be joined
};

/// One pixel of a line. Its slices have `room` cells, a multiple of VolumeShape::kGranule, and all
/// of these may be read and written; those behind `count` become infinite.
template <class Cell>
struct WalkedPixel {
  int u;
  int begin, count, room;
  int first;    ///< cell of a line of path costs that the slice begins with
  Cell* least;  ///< min_i L(p, i) of each path; infinite if there is no match at all
  const std::uint8_t* cost;
  std::uint16_t* sums;
  const std::uint8_t* classes;    ///< match classes of all steps, of each disparity
  const std::uint8_t* next_cost;  ///< of a pixel that follows soon: worth having in the cache
  const std::uint16_t* next_sums;
};

template <class Cell>
class PassWalk {
 public:
  using Pixel = typename PathLines<Cell>::Pixel;
  using Line = WalkedLine<Cell>;

  /// `step` says what is the same for all passes; paths, terms and classes are found here.
  PassWalk(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
           const PathLayout& layout, PassStep step, AggregatedVolume& sums);

  const PassStep& step() const { return step_; }
  const PassFrame& frame() const { return frame_; }
  /// How far line v - 1 must be ahead of line v.
  int lag() const { return lag_; }

  /// Fetches the penalties of all image rows, if the pass crosses them with each line.
  void load_penalties();
  /// Fetches those of a line that is an image row.
  void load_penalties(int v);
  Line begin_line(int v);

  /// Pixels of a line are opened one after the other. If the pixel has no room, that is all there
  /// is to do about it. Inlined, so that what is found never is in memory: there it would be
  /// written in pieces and read back at once, for which processors have to wait.
  [[gnu::always_inline]] WalkedPixel<Cell> open(Line& line, int u);

  /// Term i of a path. Of two terms, one that does not count is replaced by the other one, whose
  /// mean with itself it is. A single one, or both, may be looked at: they bring nothing.
  Term<Cell> term(const Line& line, const WalkedPixel<Cell>& pixel, int path, int i,
                  int terms) const {
    int step = path * terms + i;
    if (terms == 2 && !line.back[step][pixel.u].counts()) {
      const int other = step + 1 - 2 * i;
      if (line.back[other][pixel.u].counts()) step = other;
    }
    const Pixel& previous = line.back[step][pixel.u];
    const bool holds_all =
        pixel.begin - 1 >= previous.from && pixel.begin + pixel.room <= previous.to;
    const Cell* const cells = holds_all
                                  ? line.back_costs[step] + (previous.zero + pixel.begin)
                                  : joined(pixel, previous, line.back_costs[step],
                                           line.scratch + std::ptrdiff_t{scratch_stride_} * step);
    return {cells, previous.least[path], step, line.p1[step], line.p2[step]};
  }

 private:
  // Passes that go backwards or along columns are no pattern that processors foresee.
  static constexpr int kCellsFetchedAhead = 4, kSlicesFetchedAhead = 24;  // in pixels
  static constexpr int kGranule = VolumeShape::kGranule;

  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
  };

  cv::Point pixel_ahead(const Line& line, int u, int pixels) const {
    return frame_.pixel(std::min(u + pixels, frame_.length() - 1), line.v);
  }
  void find_penalties(Line& line, cv::Point at) const;

  /// L(previous, .) from the first disparity of `pixel` on, where it does not hold all that the
  /// pixel looks at: copied in between more infinite costs.
  static const Cell* joined(const WalkedPixel<Cell>& pixel, const Pixel& previous,
                            const Cell* costs, Cell* scratch);

  const CostVolume& costs_;
  const VolumeShape& shape_;
  AggregatedVolume& sums_;
  PassStep step_;
  PassFrame frame_;
  std::vector<Step> steps_;  // those of the first path, of the second...
  int lag_;
  PathLines<Cell> lines_;
  PassPenalties<Cell> penalties_;
  std::vector<std::vector<Cell>> scratch_;  // one per line of the ring
  int scratch_stride_;
};

template <class Cell>
inline WalkedPixel<Cell> PassWalk<Cell>::open(Line& line, int u) {
  const cv::Point later = pixel_ahead(line, u, kSlicesFetchedAhead);
  __builtin_prefetch(&shape_.slice(later.y, later.x));
  const cv::Point at = frame_.pixel(u, line.v);
  const VolumeShape::Slice& slice = shape_.slice(at.y, at.x);
  WalkedPixel<Cell> pixel;
  pixel.u = u;
  pixel.count = slice.count;
  pixel.room = VolumeShape::rounded_up(slice.count);
  pixel.begin = slice.begin;
  Pixel& kept = lines_.open(u, line.v, slice.begin, pixel.room);
  pixel.first = kept.zero + slice.begin;
  pixel.least = kept.least;
  if (pixel.room == 0) {
    std::fill_n(pixel.least, step_.paths, kInfinite<Cell>);
    return pixel;
  }
  const std::int64_t offset = shape_.offset(at.y, slice);
  pixel.cost = costs_.data() + offset;
  pixel.sums = sums_.data() + offset;
  const cv::Point next = pixel_ahead(line, u, kCellsFetchedAhead);
  const std::int64_t next_offset = shape_.offset(next.y, next.x);
  pixel.next_cost = costs_.data() + next_offset;
  pixel.next_sums = sums_.data() + next_offset;
  const PixelClasses& base = penalties_.base();
  const bool crosses_rows = line.penalty_slot < 0;
  const int slot = crosses_rows ? at.y : line.penalty_slot;
  pixel.classes = nullptr;
  if (step_.match_classes > 1) {
    pixel.classes = penalties_.match_at(slot, at.x, slice.begin);
    if (crosses_rows) __builtin_prefetch(penalties_.match_at(later.y, later.x, slice.begin));
  }
  if (crosses_rows && base.count() > 1) __builtin_prefetch(base.at(later.y, later.x));
  if (base.count() > 1 && *base.at(slot, at.x) != line.base_classes)
    find_penalties(line, {at.x, slot});
  return pixel;
}

}  // namespace xgm::aggregation
