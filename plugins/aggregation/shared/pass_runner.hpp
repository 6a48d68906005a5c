// SPDX-License-Identifier: Apache-2.0
// Runs one pass: at each pixel extends all its paths, and adds what they bring to the sums.
#pragma once

#include <optional>
#include <vector>

#include "plugins/aggregation/shared/line_progress.hpp"
#include "plugins/aggregation/shared/path_lines.hpp"
#include "plugins/aggregation/shared/step_penalties.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// How costs become path costs and sums.
template <class Cell>
struct PathArithmetic {
  Cell unit;                ///< path cost of a cost of one
  Cell infinite;            ///< above any finite path cost; leaves room for P1
  int extra_bits;           ///< fraction bits that path costs have and sums have not
  std::uint16_t cost_unit;  ///< what a cost of one is in the sums, beside what paths bring
};

template <class Cell>
class PassRunner {
 public:
  PassRunner(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
             const PathArithmetic<Cell>& arithmetic, AggregatedVolume& sums);

  /// The first pass writes the sums, the others add to them. Tells `progress` of each line.
  void run(bool first_pass, LineProgress& progress);
  int lines() const { return frame_.lines(); }

 private:
  struct Step {
    int along, across;  // p - x is pixel u - along of line v - across
    StepPenalties<Cell> penalties;
  };
  struct Pixel {
    int u, v;
    cv::Point at;
    int begin, count;
    int penalty_slot;
  };
  /// L(p - x, d) for the disparities of p.
  struct Previous {
    const Cell* cells;
    Cell least;
    const StepPenalties<Cell>* penalties;
  };
  /// Working memory of a line.
  struct Scratch {
    explicit Scratch(int max_count);
    std::vector<PassSum<Cell>> sum;
    struct OfStep {
      std::vector<Cell> joined, p1, p2;
    } of_step[2];
  };

  int lag() const;
  void load_penalties(int slot, int y);
  Pixel pixel(int u, int v) const;
  void visit(const Pixel& p, bool first_pass);
  void extend_path(const Pixel& p, int path, Scratch& scratch);
  std::optional<Previous> look_back(const Pixel& p, const Step& step, int path,
                                    std::vector<Cell>& joined);
  Cell extend_from(const Pixel& p, const Previous* previous, int count, Cell* path,
                   Scratch& scratch) const;

  const CostVolume& costs_;
  const VolumeShape& shape_;
  AggregatedVolume& sums_;
  PathArithmetic<Cell> arithmetic_;
  PassFrame frame_;
  std::vector<std::vector<Step>> paths_;
  PathLines<Cell> lines_;
  std::vector<Scratch> scratch_;  // one per line of the ring
};

extern template class PassRunner<std::uint8_t>;
extern template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
