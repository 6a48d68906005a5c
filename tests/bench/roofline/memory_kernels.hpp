// SPDX-License-Identifier: Apache-2.0
// Ways through memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace xgm::bench {

/// `count` is a multiple of 64; both buffers are aligned to 64 bytes.
struct MemoryLoops {
  std::string target;
  /// The sum of all cells, so that they have to be read.
  std::uint64_t (*read)(const std::uint16_t* from, std::size_t count) = nullptr;
  /// Ordinary stores: a processor reads a cache line before it changes a part of it.
  void (*write)(std::uint16_t* to, std::size_t count) = nullptr;
  /// Stores that go past the caches, and read nothing.
  void (*write_streaming)(std::uint16_t* to, std::size_t count) = nullptr;
  void (*copy)(const std::uint16_t* from, std::uint16_t* to, std::size_t count) = nullptr;
  /// to += from, as a pass over a sum volume does with costs at hand.
  void (*add)(const std::uint16_t* from, std::uint16_t* to, std::size_t count) = nullptr;
  /// to += 1
  void (*change)(std::uint16_t* to, std::size_t count) = nullptr;
};

/// Of the best SIMD target of this processor.
MemoryLoops memory_loops();

}  // namespace xgm::bench
