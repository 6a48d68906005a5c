// SPDX-License-Identifier: Apache-2.0
// Runs one pass: at each pixel finds what its paths look back at, and extends them.
#pragma once

#include <vector>

#include "plugins/aggregation/shared/line_progress.hpp"
#include "plugins/aggregation/shared/path_lines.hpp"
#include "plugins/aggregation/shared/pixel_step.hpp"
#include "plugins/aggregation/shared/step_penalties.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

template <class Cell>
class PassRunner {
 public:
  /// `step` says what is the same for all passes; paths, terms and classes are found here.
  PassRunner(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
             PassStep step, AggregatedVolume& sums);

  /// Tells `progress` of each line.
  void run(LineProgress& progress);
  int lines() const { return frame_.lines(); }

 private:
  using Pixel = typename PathLines<Cell>::Pixel;
  static constexpr int kLinesLookedBack = 2;

  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
    StepPenalties<Cell> penalties;
  };
  /// A line of pixels and those that it looks back at.
  struct Line {
    int v;
    Pixel* back[kLinesLookedBack + 1];  // line v, v - 1, ...; nullptr before the first one
    int penalty_slot;                   // -1: that of the image row
    Cell* scratch;                      // a slice per term that has to be joined
    PixelStep<Cell> step;
    bool has_doubles;  // terms that took the place, and the penalties, of another one
  };

  int lag() const;
  void load_penalties(int slot, int y);
  Line begin_line(int v);
  void visit(Line& line, int u);
  void find_terms(Line& line, int u, const Pixel& pixel) const;
  void find_penalties(Line& line, cv::Point at) const;
  const Pixel* look_back(const Line& line, int u, const Step& step) const;
  const Cell* joined(const Pixel& pixel, const Pixel& previous, const Cell* cells,
                     Cell* scratch) const;

  const CostVolume& costs_;
  const VolumeShape& shape_;
  AggregatedVolume& sums_;
  PassStep step_;
  PassFrame frame_;
  std::vector<Step> steps_;  // those of the first path, of the second...
  bool same_penalties_ = true;
  PathLines<Cell> lines_;
  std::vector<std::vector<Cell>> scratch_;  // one per line of the ring
  std::vector<Cell> nothing_;             // what a path that starts at a pixel looks back at: zeros
  std::vector<std::uint8_t> no_classes_;  // where one step has no match classes and another has
  int scratch_stride_;
  ExtendPaths<Cell> extend_;
};

extern template class PassRunner<std::uint8_t>;
extern template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
