// SPDX-License-Identifier: Apache-2.0
// The tables of a bench, before they are written in one format or another.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/bench_tables.hpp"

namespace xgm {

struct TableCell {
  std::string text;
  bool best = false;
};

/// The first `names` columns are names, the others figures.
struct Table {
  std::string title;
  std::size_t names = 1;
  std::vector<std::string> header;
  std::vector<std::vector<TableCell>> rows{};
  std::vector<std::string> notes{};  ///< what went wrong in it
};

inline constexpr const char* kNoFigure = "–";

/// The paper's Table 1: a row per pipeline, averages over the scenes of a set.
Table average_table(const BenchResult& result, const std::string& set);
/// A row per scene and pipeline.
Table scene_table(const BenchResult& result, const std::string& set);
/// What the figures mean, a sentence each.
std::vector<std::string> explanations(const BenchResult& result);

/// "done", "failed" or "not run"
const char* state_text(CellState state);

/// Two decimals of a share in percent, and so on; kNoFigure for what is not finite.
std::string figure_text(double value, int decimals);

}  // namespace xgm
