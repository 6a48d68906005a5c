// SPDX-License-Identifier: Apache-2.0
// Memory of volumes: large, aligned, not initialised, and used again within a run.
#pragma once

#include <cstddef>
#include <memory>

#include "xgm/base/export.hpp"

namespace xgm {

/// A cache line, and the widest vector.
inline constexpr std::size_t kBufferAlignment = 64;

class BufferPool;
struct RunChange;

struct XGM_API BufferDeleter {
  std::shared_ptr<BufferPool> pool{};  ///< where it came from; null: the heap
  void operator()(void* cells) const;
};
/// May be freed by any thread, and outlive the BufferReuse in which it was made.
using AlignedBuffer = std::unique_ptr<void, BufferDeleter>;

/// Throws std::bad_alloc if there is no such memory.
XGM_API AlignedBuffer new_buffer(std::size_t bytes);

/// While one lives, memory that volumes of the calling thread give back, and of the threads of its
/// loops, is kept for the next ones, so that these need not wait until the system has found and
/// cleared it. Never more is held than was in use at once; what is kept goes back to the system
/// when this object dies, or if memory runs out. One that is made while another one lives in the
/// same thread shares the memory of that one.
class XGM_API BufferReuse {
 public:
  BufferReuse();
  ~BufferReuse();
  BufferReuse(const BufferReuse&) = delete;
  BufferReuse& operator=(const BufferReuse&) = delete;

 private:
  std::unique_ptr<RunChange> change_;
};

}  // namespace xgm
