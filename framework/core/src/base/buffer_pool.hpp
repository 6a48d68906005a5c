// SPDX-License-Identifier: Apache-2.0
// A pool of blocks for several threads. Buffers keep the pool alive that they come from.
#pragma once

#include <cstddef>
#include <mutex>

#include "base/block_pool.hpp"

namespace xgm {

class BufferPool {
 public:
  enum class Kept { for_the_next, nothing };
  explicit BufferPool(Kept kept) : kept_(kept) {}

  std::byte* take(std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    return blocks_.take(bytes);
  }
  void give_back(std::byte* block) {
    const std::scoped_lock lock(mutex_);
    blocks_.give_back(block);
    if (kept_ == Kept::nothing) blocks_.trim();
  }
  /// From here on nothing is kept.
  void close() {
    const std::scoped_lock lock(mutex_);
    kept_ = Kept::nothing;
    blocks_.trim();
  }

 private:
  std::mutex mutex_;
  BlockPool blocks_;
  Kept kept_;
};

}  // namespace xgm
