// SPDX-License-Identifier: Apache-2.0
// A pass over a volume as seen from a pixel: where its cells are, and what its paths look back at.
#pragma once

#include <cstddef>
#include <vector>

#include "plugins/aggregation/path_engine/line_layout.hpp"
#include "plugins/aggregation/path_engine/pass.hpp"
#include "plugins/aggregation/path_engine/pass_penalties.hpp"
#include "plugins/aggregation/path_engine/path_lines.hpp"
#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// Lines that a thread walks along at once, a pixel of each in turn. A path along the line has to
/// wait for its least cost at one pixel before the next; meanwhile the other lines advance.
inline constexpr int kBand = 4;
constexpr int bands_of(int lines) { return (lines + kBand - 1) / kBand; }

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
  int v;
  bool begins_sums;  ///< with cost_weight * C, or adds to them
  cv::Point start;   ///< pixel 0 in the image
  LineLayout layout;
  Strided<VolumeShape::Slice> slices;
  Strided<std::uint8_t> base_classes;   ///< if there are several
  Strided<std::uint8_t> match_classes;  ///< if there are several: those of disparity 0
  LinePixels<Cell> pixels;
  LinePixels<Cell> back[kMaxSteps];                  ///< back[t].at(u) is p - x of step t
  const std::atomic<bool>* any_lost[kFarthest + 1];  ///< in this line, and those before it
  const Cell* back_costs[kMaxSteps];                 ///< of its line and path
  Cell* costs[kMaxPaths];                            ///< of this line
  const StepPenalties* penalties[kMaxSteps];         ///< of each step, by match class
  int known_classes;                                 ///< those of the layout that these belong to
  Cell* scratch;                ///< a slice per step, should it have to be joined
  Term<Cell> terms[kMaxSteps];  ///< of a pixel where not all is as usual
};

template <class Cell>
class PassWalk {
 public:
  using Pixels = LinePixels<Cell>;
  using Line = WalkedLine<Cell>;

  /// `step` says what is the same for all passes; paths, terms and classes are found here. Lines
  /// are counted from `first_line` on, less than kBand, so that bands can end where those of the
  /// opposite pass begin.
  PassWalk(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
           const PathLayout& layout, PassStep step, AggregatedVolume& sums, int first_line);

  const PassStep& step() const { return step_; }
  const PassFrame& frame() const { return frame_; }
  /// How far line v - 1 must be ahead of line v.
  int lag() const { return lag_; }

  /// Fetches the penalties of all image rows, if the pass crosses them with each line.
  void load_penalties();
  /// Fetches those of a line that is an image row.
  void load_penalties(int v);
  void begin_line(int v, bool begins_sums, Line& line);

  /// Lays out pixels first..last - 1 of a line, LineLayout::kPixels at most, but for what they look
  /// back at. Those that do not exist get no room; false if none does. All pixels of a line are
  /// classes_of_pixels one after the other.
  bool lay_out(Line& line, int first, int last);

  const std::uint8_t* costs() const { return costs_.data(); }
  std::uint16_t* sums() const { return sums_.data(); }

  /// Makes line.penalties those of element k of the layout.
  [[gnu::always_inline]] void find_penalties(Line& line, int k) const {
    if (line.layout.base_classes[k] != line.known_classes) change_penalties(line, k);
  }
  /// Match classes of all steps, of each of its disparities; null if there is one class only.
  [[gnu::always_inline]] const std::uint8_t* match_classes(const Line& line, int u,
                                                           int begin) const {
    if (line.match_classes.first == nullptr) return nullptr;
    __builtin_prefetch(line.match_classes.at(u + kClassesFetchedAhead) + begin);
    return line.match_classes.at(u) + begin;
  }

  /// The terms of all paths of element k of the layout, one path's after the other. Of two terms,
  /// one that does not count is replaced by the other one, whose mean with itself it is. A single
  /// one, or both, may be looked at: they bring nothing.
  const Term<Cell>* find_terms(Line& line, int k) const;

 private:
  // Passes that go backwards or along columns are no pattern that processors foresee.
  static constexpr int kClassesFetchedAhead = 24;  // in pixels
  static constexpr int kGranule = VolumeShape::kGranule;

  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
  };

  std::int64_t offset_of(const Line& line, int u) const {
    return shape_.offset(line.start.y + u * frame_.along().dy, *line.slices.at(u));
  }
  void plan_classes(Line& line, int from, int to) const;
  void change_penalties(Line& line, int k) const;
  /// L(previous, .) where it does not hold all of these: copied in between more infinite costs.
  static const Cell* joined(int begin, int room, const Pixels& previous, const Cell* costs,
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

}  // namespace xgm::aggregation
