// SPDX-License-Identifier: Apache-2.0
// The figures of surface benches, in the order of the tables.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/evaluation/table.hpp"
#include "xgm/geo/bench/surface_bench.hpp"

namespace xgm::geo {

struct SurfaceColumn {
  std::string key;   ///< in CSV and JSON
  std::string head;  ///< in tables
  int decimals = 2;
  Best best = Best::lowest;
  double scale = 1;  ///< of the table's figure
  std::function<double(const SurfaceCell&)> value;
  bool largest = false;  ///< an average is the largest of all, not their mean
};

/// In bench.csv and bench.json.
std::vector<SurfaceColumn> surface_columns();
/// Those that stand in tables of the result.
std::vector<SurfaceColumn> table_columns(const SurfaceBenchResult& result);

/// Of one pipeline over the scenes of a set that it has finished.
struct SurfaceAverage {
  std::size_t scenes = 0;       ///< that the pipeline has finished
  std::size_t of = 0;           ///< that the set has
  bool comparable = true;       ///< whether it has finished all that any pipeline has finished
  std::vector<double> figures;  ///< one per column
};
SurfaceAverage average(const SurfaceBenchResult& result, std::size_t pipeline,
                       const std::string& set, const std::vector<SurfaceColumn>& columns);
/// In the order of the scenes.
std::vector<std::string> sets(const SurfaceBenchResult& result);

/// Averages of a set, a row per pipeline; and all scenes of it.
Table average_table(const SurfaceBenchResult& result, const std::string& set);
Table scene_table(const SurfaceBenchResult& result, const std::string& set);
/// Rank correlations of the figures of surfaces with those of disparities over all cells.
Table relation_table(const SurfaceBenchResult& result);
/// Whether any cell knows the errors of its disparities.
bool knows_disparities(const SurfaceBenchResult& result);
/// What the figures mean, a sentence each.
std::vector<std::string> explanations(const SurfaceBenchResult& result);

}  // namespace xgm::geo
