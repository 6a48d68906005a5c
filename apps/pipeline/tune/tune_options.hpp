// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline tune".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/bench_options.hpp"

namespace xgm::cli {

struct TuneOptions {
  std::string pipeline;
  std::vector<std::string> parameters;
  int budget = 0;
  double held_out = 0.3;
  double threshold = 1;
  std::uint64_t seed = 0;
  BenchOptions bench;

  /// Throws UsageError.
  BenchRules rules() const;
  void check() const;
};

void add_tune_options(Command command, TuneOptions& options);

}  // namespace xgm::cli
