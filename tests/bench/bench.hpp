// SPDX-License-Identifier: Apache-2.0
// What the files of a bench program share.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace xgm::bench {

/// Registers every benchmark of the program.
void register_all();

/// So many of `what` are done in each iteration: told per second.
inline void count(benchmark::State& state, const std::string& what, std::int64_t per_iteration) {
  const auto total = static_cast<double>(per_iteration) * static_cast<double>(state.iterations());
  state.counters[what] = benchmark::Counter(total, benchmark::Counter::kIsRate);
}

}  // namespace xgm::bench
