// SPDX-License-Identifier: Apache-2.0
// Averages of a bench, and its tables in several formats.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// Figures of several scenes: the weighted mean of errors, the mean of seconds, density and
/// evaluations, and the maximum of memory.
struct BenchAverage {
  std::size_t scenes = 0;   ///< that the pipeline has finished
  std::size_t of = 0;       ///< that the set has
  bool comparable = false;  ///< whether it has finished every scene that any pipeline has finished
  BenchCell figures;        ///< its only region is the evaluated one; none without truth
};
XGM_API BenchAverage average(const BenchResult& result, std::size_t pipeline,
                             const std::string& set);
/// The averages of each set, in the order of the sets.
XGM_API std::vector<std::string> sets(const BenchResult& result);
/// The region of a cell that the rules select; null without truth, or without such a region.
XGM_API const Evaluation* judged(const BenchCell& cell, const BenchRules& rules);

/// Averages only, for terminals.
XGM_API std::string bench_text(const BenchResult& result);
/// Averages and scenes; the best of every column in bold.
XGM_API std::string bench_markdown(const BenchResult& result);
/// The same tables as a fragment of an HTML page.
XGM_API std::string bench_tables_html(const BenchResult& result);
/// One line per average and per cell, shares from 0 to 1.
XGM_API std::string bench_csv(const BenchResult& result);
/// All results, including all other regions and the resolved pipelines.
XGM_API std::string bench_json(const BenchResult& result);
/// An HTML page with the tables and as many maps as fit.
XGM_API std::string bench_html(const BenchResult& result);

}  // namespace xgm
