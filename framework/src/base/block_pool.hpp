// SPDX-License-Identifier: Apache-2.0
// Blocks of memory straight from the system, in huge pages, and those that wait to be used again.
#pragma once

#include <cstddef>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

struct Block {
  std::byte* begin = nullptr;
  std::size_t bytes = 0;  ///< pools round it up to whole huge pages
};

/// A free block is made to fit whoever asks next: what is missing is added at its end, what is too
/// much is split off and stays free. Free blocks are cut as soon as free and used ones together
/// exceed what was once in use, so that the pool never makes a program larger than it would be
/// without. Not safe for several threads.
class XGM_API BlockPool {
 public:
  BlockPool() = default;
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;
  ~BlockPool() { trim(); }

  /// Throws std::bad_alloc if there is no such memory, even after the free blocks are dropped.
  std::byte* take(std::size_t bytes);
  /// `block` is one that take() gave, with the bytes that were asked for.
  void give_back(Block block);
  /// Returns all free blocks to the system.
  void trim();

  std::size_t used_bytes() const { return used_; }
  std::size_t free_bytes() const { return free_bytes_; }

 private:
  Block take_free(std::size_t bytes);
  void add_free(Block block);
  std::byte* fit(Block block, std::size_t bytes);
  void drop_surplus();

  std::vector<Block> free_;
  std::size_t used_ = 0, free_bytes_ = 0;
  std::size_t most_used_ = 0;  // since the last trim
};

}  // namespace xgm
