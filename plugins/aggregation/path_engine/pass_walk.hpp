// SPDX-License-Identifier: Apache-2.0
// One pass over a volume: finds the cells of each pixel, and the terms that its paths read.
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

/// Lines that a thread walks along at once, one pixel of each in turn. A path along a line needs
/// the minimum of one pixel before it can begin the next; meanwhile the other lines advance.
inline constexpr int kBand = 4;
constexpr int bands_of(int lines) { return (lines + kBand - 1) / kBand; }

/// The path costs that a pass has to keep if `threads` threads walk.
LinesKept lines_kept(const Pass& pass, int lines, int threads);

/// A property of the pixels of a line, `step` elements apart.
template <class T>
struct Strided {
  const T* first = nullptr;
  std::ptrdiff_t step = 0;

  const T* at(int u) const { return first + u * step; }
};

/// The state of a line that is being walked along.
template <class Cell>
struct WalkedLine {
  int v;
  bool begins_sums;  ///< whether sums are begun with cost_weight * C, or added to
  cv::Point start;   ///< image coordinates of pixel 0
  LineLayout layout;
  Strided<VolumeShape::Slice> slices;
  Strided<std::uint8_t> base_classes;   ///< null if there is one class
  Strided<std::uint8_t> match_classes;  ///< of disparity 0; null if there is one class
  LinePixels<Cell> pixels;
  LinePixels<Cell> back[kMaxSteps];  ///< back[t].at(u) is the previous pixel of step t
  const std::atomic<bool>* any_lost[kFarthest + 1];  ///< of this line, and of the lines before it
  const Cell* back_costs[kMaxSteps];                 ///< path costs that step t reads
  Cell* costs[kMaxPaths];                            ///< path costs of this line
  const StepPenalties* penalties;                    ///< of a pixel: by step and match class
  StepPenalties* looked_up;                          ///< room for them, if classes are not packed
  Cell* scratch;                                     ///< a slice per step, for PassWalk::joined()
  Term<Cell> terms[kMaxSteps];                       ///< of a pixel that is not the usual case
};

template <class Cell>
class PassWalk {
 public:
  using Pixels = LinePixels<Cell>;
  using Line = WalkedLine<Cell>;

  /// `step` holds what is the same for all passes; its paths, terms and classes are set here. Lines
  /// are numbered from `first_line` on, which is less than kBand, so that the bands of opposite
  /// passes cover the same lines.
  PassWalk(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
           const PathLayout& layout, PassStep step, AggregatedVolume& sums, int first_line);

  const PassStep& step() const { return step_; }
  const PassFrame& frame() const { return frame_; }
  /// How far line v - 1 must be ahead of line v.
  int lag() const { return lag_; }

  /// Loads the penalties of all image rows, if lines are columns.
  void load_penalties();
  /// Loads the penalties of line v, if lines are rows.
  void load_penalties(int v);
  void begin_line(int v, bool begins_sums, Line& line);

  /// Lays out pixels first..last - 1 of a line, at most LineLayout::kPixels, except for `back` and
  /// `odd`. Pixels that do not exist get no room; returns false if none exists. All pixels of a
  /// line are laid out one after the other.
  bool lay_out(Line& line, int first, int last);

  const std::uint8_t* costs() const { return costs_.data(); }
  std::uint16_t* sums() const { return sums_.data(); }

  /// Sets line.penalties to those of element k of the layout.
  [[gnu::always_inline]] void find_penalties(Line& line, int k) const {
    const int classes = line.layout.base_classes[k];
    if (classes == LineLayout::kUnknown) return look_up_penalties(line, k);
    line.penalties = penalties_.of(classes);
  }
  /// Match classes of pixel u from disparity `begin` on; null if there is one class only.
  [[gnu::always_inline]] const std::uint8_t* match_classes(const Line& line, int u,
                                                           int begin) const {
    if (line.match_classes.first == nullptr) return nullptr;
    __builtin_prefetch(line.match_classes.at(u + kClassesFetchedAhead) + begin);
    return line.match_classes.at(u) + begin;
  }

  /// The terms of all paths at element k of the layout, path by path. If the previous pixel of one
  /// of two terms is lost, the other term takes its place: the mean of a message with itself is
  /// that message. If all previous pixels of a path are lost, its terms stay: their message is 0.
  const Term<Cell>* find_terms(Line& line, int k) const;

 private:
  // Hardware prefetchers do not recognise the access pattern of passes backward or along columns.
  static constexpr int kClassesFetchedAhead = 24;  // in pixels
  static constexpr int kGranule = VolumeShape::kGranule;

  struct Step {
    int along, across;  // the previous pixel is pixel u - along of line v - across
  };

  std::int64_t offset_of(const Line& line, int u) const {
    return shape_.offset(line.start.y + u * frame_.along().dy, *line.slices.at(u));
  }
  void plan_classes(Line& line, int from, int to) const;
  void look_up_penalties(Line& line, int k) const;
  /// Path costs of the previous pixel where those in memory do not cover disparities begin - 1 to
  /// begin + room: copied to `scratch`, with infinite costs around them.
  static const Cell* joined(int begin, int room, const Pixels& previous, const Cell* costs,
                            Cell* scratch);

  const CostVolume& costs_;
  const VolumeShape& shape_;
  AggregatedVolume& sums_;
  PassStep step_;
  PassFrame frame_;
  std::vector<Step> steps_;  // path by path
  int lag_;
  PathLines<Cell> lines_;
  PassPenalties<Cell> penalties_;
  std::vector<std::vector<Cell>> scratch_;             // one per line of the ring
  std::vector<std::vector<StepPenalties>> looked_up_;  // likewise
  int scratch_stride_;
};

}  // namespace xgm::aggregation
