// SPDX-License-Identifier: Apache-2.0
// What "pipeline bench" writes beside its cells, and that nothing it reads is lost to it.
#pragma once

#include <array>
#include <string>

#include "bench/bench_options.hpp"
#include "xgm/evaluation/bench_tables.hpp"

namespace xgm::cli {

struct BenchTable {
  const char* file;
  std::string (*text)(const BenchResult&);
};
inline constexpr std::array kBenchTables{
    BenchTable{"bench.md", bench_markdown}, BenchTable{"bench.csv", bench_csv},
    BenchTable{"bench.json", bench_json}, BenchTable{"bench.html", bench_html}};

/// Throws UsageError if a file that the bench or one of its runs reads would be replaced.
void require_inputs_kept(const BenchOptions& options, const BenchRequest& request,
                         const Registry& registry);

}  // namespace xgm::cli
