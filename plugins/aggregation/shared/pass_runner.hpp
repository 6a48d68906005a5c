// SPDX-License-Identifier: Apache-2.0
// Runs one pass: at each pixel finds what its paths look back at, and extends them.
#pragma once

#include <vector>

#include "plugins/aggregation/shared/line_progress.hpp"
#include "plugins/aggregation/shared/pass_penalties.hpp"
#include "plugins/aggregation/shared/path_lines.hpp"
#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// What the threads need at a time, of the `lines` of a pass.
LinesKept lines_kept(const Pass& pass, int lines, int threads);

template <class Cell>
class PassRunner {
 public:
  /// `step` says what is the same for all passes; paths, terms and classes are found here.
  PassRunner(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
             const PathLayout& layout, PassStep step, AggregatedVolume& sums);

  /// Tells `progress` of each line.
  void run(LineProgress& progress);
  int lines() const { return frame_.lines(); }

 private:
  using Pixel = typename PathLines<Cell>::Pixel;

  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
  };
  /// A line of pixels and what it looks back at.
  struct Line {
    int v;
    const Pixel* back[kMostPaths * kMostTerms];  // back[i][u]: p - x of step i
    int penalty_slot;                            // -1: that of the image row
    Cell* scratch;                               // a slice per term that has to be joined
    PixelStep<Cell> step;
    int base_classes;  // those that the terms have the penalties of, if packed; -1 if any has not
  };

  void begin_band(int v, int count);
  Line begin_line(int v);
  cv::Point pixel_ahead(const Line& line, int u, int pixels) const;
  void visit(Line& line, int u);
  template <int kTerms>
  void find_terms(Line& line, int u, const Pixel& pixel) const;
  void find_penalties(Line& line, cv::Point at, int begin) const;
  const Cell* previous_cells(const Pixel& pixel, const Pixel& previous, int path,
                             Cell* scratch) const;
  static const Cell* joined(const Pixel& pixel, const Pixel& previous, const Cell* cells,
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
  ExtendPaths<Cell> extend_;
};

extern template class PassRunner<std::uint8_t>;
extern template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
