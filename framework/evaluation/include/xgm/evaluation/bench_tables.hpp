// SPDX-License-Identifier: Apache-2.0
// What a bench amounts to: averages, and tables in several formats.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// Figures of several scenes: those by the truth weighted, seconds and density their mean, memory
/// the largest, evaluations the mean.
struct BenchAverage {
  std::size_t scenes = 0;   ///< that the pipeline has done
  std::size_t of = 0;       ///< that the set has
  bool comparable = false;  ///< done on every scene that any pipeline has done
  BenchCell figures;        ///< its only region is the one judged; none without truth
};
XGM_API BenchAverage average(const BenchResult& result, std::size_t pipeline,
                             const std::string& set);
/// The sets, in the order of the plan.
XGM_API std::vector<std::string> sets(const BenchResult& result);
/// The region of a cell that the rules ask for; null without truth, or if it has no such region.
XGM_API const Evaluation* judged(const BenchCell& cell, const BenchRules& rules);

/// Averages alone, for terminals.
XGM_API std::string bench_text(const BenchResult& result);
/// Averages and scenes; the best of every column in bold.
XGM_API std::string bench_markdown(const BenchResult& result);
/// The same tables as a part of a page.
XGM_API std::string bench_tables_html(const BenchResult& result);
/// One line per average and per cell, shares from 0 to 1.
XGM_API std::string bench_csv(const BenchResult& result);
/// All there is: also the regions not asked for, and the resolved pipelines.
XGM_API std::string bench_json(const BenchResult& result);
/// A page of its own with the tables and, as far as they fit, the maps.
XGM_API std::string bench_html(const BenchResult& result);

}  // namespace xgm
