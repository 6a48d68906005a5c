// SPDX-License-Identifier: Apache-2.0
// Memory of volumes: large, aligned, not initialised, and used again within a run.
#pragma once

#include <cstddef>
#include <memory>

#include "xgm/base/export.hpp"

namespace xgm {

/// A cache line, and the widest vector.
inline constexpr std::size_t kBufferAlignment = 64;

struct XGM_API BufferDeleter {
  std::size_t bytes = 0;  ///< as asked for
  void operator()(void* cells) const;
};
using AlignedBuffer = std::unique_ptr<void, BufferDeleter>;

/// Throws std::bad_alloc if there is no such memory.
XGM_API AlignedBuffer new_buffer(std::size_t bytes);

/// While one lives, memory that volumes give back is kept for the next ones, so that these need not
/// wait until the system has found and cleared it. Never more is held than was in use at once; what
/// is kept goes back to the system when the last of these objects dies, or if memory runs out.
class XGM_API BufferReuse {
 public:
  BufferReuse();
  ~BufferReuse();
  BufferReuse(const BufferReuse&) = delete;
  BufferReuse& operator=(const BufferReuse&) = delete;
};

}  // namespace xgm
