// SPDX-License-Identifier: Apache-2.0
// A pass over a volume as seen from a pixel: where its cells are, and what its paths look back at.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
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

/// What the pixels of a line have, `step` elements apart.
template <class T>
struct Strided {
  const T* first = nullptr;
  std::ptrdiff_t step = 0;

  const T* at(int u) const { return first + u * step; }
};

/// A line that is being walked along.
template <class Cell>
struct WalkedLine {
  cv::Point start;  ///< pixel 0 in the image
  typename PathLines<Cell>::Pixel* pixels;
  int cells;  ///< of each path
  Strided<VolumeShape::Slice> slices;
  Strided<std::uint8_t> base_classes;   ///< if there are several
  Strided<std::uint8_t> match_classes;  ///< if there are several: those of disparity 0
  const typename PathLines<Cell>::Pixel* back[kMostSteps];  ///< back[t][u]: p - x of step t
  const Cell* back_costs[kMostSteps];                       ///< of its line and path
  Cell* costs[kMostPaths];                                  ///< of this line
  const StepPenalties<Cell>* penalties[kMostSteps];         ///< of each step, by match class
  int known_classes;  ///< base classes that these belong to, if packed; else -1
  Cell* scratch;      ///< a slice per step, should it have to be joined
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
  [[gnu::always_inline]] WalkedPixel<Cell> open(Line& line, int u) const;

  /// The terms of `paths` paths from first_path on, one path's after the other, at pixel u with
  /// `room` cells from disparity `begin` on. Of two terms, one that does not count is replaced by
  /// the other one, whose mean with itself it is. A single one, or both, may be looked at: they
  /// bring nothing. Takes numbers, not the pixel, which then need not be in memory.
  void find_terms(const Line& line, int u, int begin, int room, int first_path, int paths,
                  Term<Cell>* terms) const;

  /// The same for a number that is known, of a pixel of which usually all terms count and are in
  /// one piece. One branch for all of them: guessing each wrong costs as much as guessing all.
  template <int kPaths, int kTerms>
  [[gnu::always_inline]] auto terms(const Line& line, const WalkedPixel<Cell>& pixel,
                                    int first_path) const {
    return terms<kTerms>(line, pixel, first_path,
                         std::make_integer_sequence<int, kPaths * kTerms>());
  }

 private:
  // Passes that go backwards or along columns are no pattern that processors foresee.
  static constexpr int kCellsFetchedAhead = 4, kSlicesFetchedAhead = 24;  // in pixels
  static constexpr int kGranule = VolumeShape::kGranule;

  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
  };

  std::int64_t offset_of(const Line& line, int u, const VolumeShape::Slice& slice) const {
    return shape_.offset(line.start.y + u * frame_.along().dy, slice);
  }
  /// For the base classes at this place.
  void find_penalties(Line& line, const std::uint8_t* classes) const;

  /// Whether path costs of `room` disparities from `begin` on, and one more on either side, are
  /// in memory.
  static bool holds(const Pixel& previous, int begin, int room) {
    return begin - 1 >= previous.from && begin + room <= previous.to;
  }
  /// 1 if the term of a step is as usual, else 0: found without a branch.
  template <int kTerms>
  static int is_usual(const Line& line, const WalkedPixel<Cell>& pixel, int step) {
    const Pixel& previous = line.back[step][pixel.u];
    const int counts = kTerms == 1 || previous.counts();
    const int begins = pixel.begin - 1 >= previous.from;
    const int ends = pixel.begin + pixel.room <= previous.to;
    return counts & begins & ends;
  }
  template <int kTerms, int... t>
  [[gnu::always_inline]] auto terms(const Line& line, const WalkedPixel<Cell>& pixel,
                                    int first_path, std::integer_sequence<int, t...>) const {
    const int first = first_path * kTerms;
    if ((is_usual<kTerms>(line, pixel, first + t) & ...) != 0) [[likely]]
      return std::array{usual_term(line, pixel, first + t, first_path + t / kTerms)...};
    Term<Cell> found[sizeof...(t)];
    constexpr int kPaths = sizeof...(t) / kTerms;
    find_terms(line, pixel.u, pixel.begin, pixel.room, first_path, kPaths, found);
    return std::array{found[t]...};
  }
  static Term<Cell> usual_term(const Line& line, const WalkedPixel<Cell>& pixel, int step,
                               int path) {
    const Pixel& previous = line.back[step][pixel.u];
    const Cell* const costs = line.back_costs[step] + (previous.zero + pixel.begin);
    return {costs, previous.least + path, step, line.penalties[step]};
  }
  /// L(previous, .) where it does not hold all of these: copied in between more infinite costs.
  static const Cell* joined(int begin, int room, const Pixel& previous, const Cell* costs,
                            Cell* scratch);

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
inline WalkedPixel<Cell> PassWalk<Cell>::open(Line& line, int u) const {
  // May lead beyond the image, which prefetching does not mind.
  __builtin_prefetch(line.slices.at(u + kSlicesFetchedAhead));
  const VolumeShape::Slice& slice = *line.slices.at(u);
  WalkedPixel<Cell> pixel;
  pixel.u = u;
  pixel.count = slice.count;
  pixel.room = VolumeShape::rounded_up(slice.count);
  pixel.begin = slice.begin;
  Pixel& kept = line.pixels[u];
  if (pixel.room == 0) {
    lines_.skip(kept);
    return pixel;
  }
  lines_.open(kept, line.cells, slice.begin, pixel.room);
  pixel.first = kept.zero + slice.begin;
  pixel.least = kept.least;
  const std::int64_t offset = offset_of(line, u, slice);
  pixel.cost = costs_.data() + offset;
  pixel.sums = sums_.data() + offset;
  const int next = std::min(u + kCellsFetchedAhead, frame_.length() - 1);
  const std::int64_t next_offset = offset_of(line, next, *line.slices.at(next));
  pixel.next_cost = costs_.data() + next_offset;
  pixel.next_sums = sums_.data() + next_offset;
  pixel.classes = nullptr;
  if (line.match_classes.first != nullptr) {
    pixel.classes = line.match_classes.at(u) + slice.begin;
    __builtin_prefetch(line.match_classes.at(u + kSlicesFetchedAhead) + slice.begin);
  }
  if (line.base_classes.first != nullptr) {
    const std::uint8_t* const classes = line.base_classes.at(u);
    __builtin_prefetch(line.base_classes.at(u + kSlicesFetchedAhead));
    if (*classes != line.known_classes) find_penalties(line, classes);
  }
  return pixel;
}

}  // namespace xgm::aggregation
