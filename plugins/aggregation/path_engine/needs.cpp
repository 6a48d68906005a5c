// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/needs.hpp"

#include <algorithm>

#include "plugins/aggregation/path_engine/pass_walk.hpp"

namespace xgm::aggregation {
namespace {

/// Bytes of PathLines. Assumes path costs of 8 bit, which all shipped pipelines have.
double line_bytes(const Workload& load, const Pass& pass, const LinesKept& kept) {
  const double length = PassFrame(load.size, pass.along, pass.across).length();
  const double pixels = std::min(length, double(kept.pixels));
  const double mean = load.cells_per_pixel + VolumeShape::kGranule;  // the margin behind a slice
  const double longest = Workload::room(load.range.size()) + VolumeShape::kGranule;
  const double whole = kept.last_lines * length * mean;
  const double part = (kept.band_lines - kept.last_lines) * pixels * longest;
  return kept.bands * (whole + part) * static_cast<double>(pass.paths.size());
}

/// Bytes of LinePixels, which all lines keep whole: little beside path costs, unless lines are as
/// long as strips are.
double pixel_bytes(const Workload& load, const Pass& pass, const LinesKept& kept) {
  const double length = PassFrame(load.size, pass.along, pass.across).length();
  const double of_pixel =
      3.0 * sizeof(int) + static_cast<double>(pass.paths.size()) * sizeof(Repeated) + 1;
  return kept.bands * kept.band_lines * length * of_pixel;
}

/// Bytes of PassPenalties, for penalties with two classes per step and view. Penalties with one
/// class need less; penalties with more classes need a byte per step.
double class_bytes(const Workload& load, int rows) {
  constexpr double kBehind = 64;  // that vectors read
  return rows * (2.0 * load.size.width + load.range.size() + kBehind);
}

double working_bytes(const Workload& load, const Pass& pass) {
  const PassFrame frame(load.size, pass.along, pass.across);
  const LinesKept kept = lines_kept(pass, frame.lines(), load.threads);
  const int rows = frame.lines_are_rows() ? kept.bands * kept.band_lines : load.size.height;
  return line_bytes(load, pass, kept) + pixel_bytes(load, pass, kept) + class_bytes(load, rows);
}

}  // namespace

Needs needs(const Workload& load, const std::vector<Pass>& passes) {
  // The forward and the backward pass each read a cost (1 byte) and read and write a sum (4 bytes).
  // A sum that is begun is not read.
  const double bytes_per_cell = 2 * 5.0 * static_cast<double>(passes.size()) - 2;
  Needs needs{.moved = bytes_per_cell * load.cells()};
  for (const Pass& pass : passes) {
    double working = 0;
    for (const Pass& way : both_directions(pass)) {
      working += working_bytes(load, way);
      for (const Path& path : way.paths)
        needs.updates += load.cells() * static_cast<double>(path.steps.size());
    }
    needs.working = std::max(needs.working, working);
  }
  return needs;
}

}  // namespace xgm::aggregation
