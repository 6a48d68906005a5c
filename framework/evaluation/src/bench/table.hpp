// SPDX-License-Identifier: Apache-2.0
// The tables of a bench, before they are written in one format or another.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/table.hpp"

namespace xgm {

/// The paper's Table 1: a row per pipeline, averages over the scenes of a set.
Table average_table(const BenchResult& result, const std::string& set);
/// A row per scene and pipeline.
Table scene_table(const BenchResult& result, const std::string& set);
/// What the figures mean, a sentence each.
std::vector<std::string> explanations(const BenchResult& result);

}  // namespace xgm
