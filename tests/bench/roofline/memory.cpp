// SPDX-License-Identifier: Apache-2.0
// How many bytes per second memory gives and takes: buffers far larger than the caches, each thread
// with its own.
#include "bench/roofline/memory_kernels.hpp"

#include <algorithm>
#include <functional>

#include "bench/bench.hpp"
#include "bench/roofline/rooflines.hpp"
#include "xgm/base/aligned_buffer.hpp"

namespace xgm::bench {
namespace {

constexpr std::size_t kBytes = std::size_t{256} << 20;  // of each buffer
constexpr std::size_t kCells = kBytes / sizeof(std::uint16_t);

struct Buffers {
  AlignedBuffer from = new_buffer(kBytes), to = new_buffer(kBytes);
  std::uint16_t* source() const { return static_cast<std::uint16_t*>(from.get()); }
  std::uint16_t* target() const { return static_cast<std::uint16_t*>(to.get()); }

  /// Memory that was never written is not there yet.
  Buffers() {
    std::fill_n(source(), kCells, std::uint16_t{1});
    std::fill_n(target(), kCells, std::uint16_t{2});
  }
};

using Pass = std::function<void(const Buffers&)>;

/// `moved`: how many of the buffer's bytes a pass reads and writes.
void add_pass(const std::string& name, int moved, const Pass& pass) {
  const auto run = [=](benchmark::State& state) {
    const Buffers buffers;
    for (auto _ : state) {
      pass(buffers);
      benchmark::ClobberMemory();
    }
    count(state, "bytes", moved * static_cast<std::int64_t>(kBytes));
  };
  const std::string title = "memory/" + name;
  benchmark::RegisterBenchmark(title.c_str(), run)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(title.c_str(), run)
      ->Threads(2)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_memory() {
  const MemoryLoops loops = memory_loops();
  add_pass("read", 1,
           [=](const Buffers& b) { benchmark::DoNotOptimize(loops.read(b.source(), kCells)); });
  add_pass("write", 1, [=](const Buffers& b) { loops.write(b.target(), kCells); });
  add_pass("write_streaming", 1,
           [=](const Buffers& b) { loops.write_streaming(b.target(), kCells); });
  add_pass("copy", 2, [=](const Buffers& b) { loops.copy(b.source(), b.target(), kCells); });
  add_pass("change_16bit", 2, [=](const Buffers& b) { loops.change(b.target(), kCells); });
  add_pass("add_16bit", 3, [=](const Buffers& b) { loops.add(b.source(), b.target(), kCells); });
}

}  // namespace xgm::bench
