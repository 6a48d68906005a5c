// SPDX-License-Identifier: Apache-2.0
// How many path updates a core can do at all: everything in the first-level cache, nothing else to
// do.
#include <cstring>
#include <memory>

#include "bench/bench.hpp"
#include "bench/roofline/path_kernels.hpp"
#include "bench/roofline/rooflines.hpp"

namespace xgm::bench {
namespace {

template <class Cell>
bool same_results(PathLoop<Cell> loop, PathLoop<Cell> reference) {
  const auto a = std::make_unique<PathBuffers<Cell>>(1);
  const auto b = std::make_unique<PathBuffers<Cell>>(1);
  loop(*a);
  reference(*b);
  return a->sums == b->sums;
}

template <class Cell>
void run_loop(benchmark::State& state, PathLoop<Cell> loop, PathLoop<Cell> reference, int paths) {
  if (!same_results(loop, reference)) {
    state.SkipWithError("gives other sums than the plain loop");
    return;
  }
  const auto buffers = std::make_unique<PathBuffers<Cell>>(1);
  for (auto _ : state) {
    loop(*buffers);
    benchmark::DoNotOptimize(buffers->sums.data());
    benchmark::ClobberMemory();
  }
  count(state, "updates", std::int64_t{kRounds} * kPixels * paths * kDisparities);
}

template <class Cell>
void add(const std::string& name, const PathLoops& loops, const PathLoops& plain,
         PathLoop<Cell> PathLoops::*loop, int paths) {
  benchmark::RegisterBenchmark(
      ("path/" + name + '/' + loops.target).c_str(),
      [=](benchmark::State& state) { run_loop<Cell>(state, loops.*loop, plain.*loop, paths); });
}

}  // namespace

void register_paths() {
  const std::vector<PathLoops> all = path_loops();
  const auto add_all = [&](const std::string& name, auto loop, int paths) {
    for (const PathLoops& loops : all) add(name, loops, all.front(), loop, paths);
  };
  add_all("sgm/8bit/four", &PathLoops::sgm8_four, 4);
  add_all("sgm/8bit/one", &PathLoops::sgm8_one, 1);
  add_all("sgm/16bit/four", &PathLoops::sgm16_four, 4);
  add_all("sgm/16bit/one", &PathLoops::sgm16_one, 1);
  add_all("mgm/8bit/four", &PathLoops::mgm8_four, 4);
  add_all("mgm/8bit/one", &PathLoops::mgm8_one, 1);
  add_all("mgm/16bit/four", &PathLoops::mgm16_four, 4);
  add_all("mgm/16bit/one", &PathLoops::mgm16_one, 1);
}

void register_all() {
  register_paths();
  register_hamming();
  register_memory();
}

}  // namespace xgm::bench
