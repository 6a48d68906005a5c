// SPDX-License-Identifier: Apache-2.0
// How many costs a core can compute at all: one row, whose strings stay in the caches.
#include <algorithm>
#include <memory>

#include "bench/bench.hpp"
#include "bench/roofline/hamming_kernels.hpp"
#include "bench/roofline/rooflines.hpp"

namespace xgm::bench {
namespace {

bool same_results(const RowLoops& loops, const RowLoops& plain) {
  const auto a = std::make_unique<RowBuffers>(1);
  const auto b = std::make_unique<RowBuffers>(1);
  for (const auto& [one, row] : {std::pair{&loops, a.get()}, std::pair{&plain, b.get()}}) {
    one->census(*row);
    one->hamming(*row);
  }
  return a->costs == b->costs;
}

void add(const std::string& name, const RowLoops& loops, const RowLoops& plain,
         void (*RowLoops::*loop)(RowBuffers&), const std::string& unit, std::int64_t count_of_row) {
  benchmark::RegisterBenchmark((name + '/' + loops.target).c_str(), [=](benchmark::State& state) {
    if (!same_results(loops, plain)) {
      state.SkipWithError("gives other costs than the plain loop");
      return;
    }
    const auto row = std::make_unique<RowBuffers>(1);
    for (auto _ : state) {
      (loops.*loop)(*row);
      benchmark::DoNotOptimize(row->costs.data());
      benchmark::ClobberMemory();
    }
    count(state, unit, count_of_row);
  });
}

}  // namespace

void register_hamming() {
  const std::vector<RowLoops> all = row_loops();
  for (const RowLoops& loops : all) {
    add("census/5x5", loops, all.front(), &RowLoops::census, "pixels", kRowWidth);
  }
  for (const RowLoops& loops : all) {
    add("hamming/224", loops, all.front(), &RowLoops::hamming, "cells",
        std::int64_t{kRowWidth} * kRowDisparities);
  }
}

}  // namespace xgm::bench
