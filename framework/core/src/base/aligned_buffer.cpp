// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/aligned_buffer.hpp"

#include <new>

#include "base/buffer_pool.hpp"
#include "base/run_state.hpp"

namespace xgm {
namespace {

// What the system grants in huge pages; less is not worth a system call.
constexpr std::size_t kMinOfPool = 4 * kHugePage;

RunState with_pool(RunState state, std::shared_ptr<BufferPool> pool) {
  state.pool = std::move(pool);
  return state;
}

}  // namespace

void BufferDeleter::operator()(void* cells) const {
  if (pool != nullptr) {
    pool->give_back(static_cast<std::byte*>(cells));
  } else {
    ::operator delete (cells, std::align_val_t{kBufferAlignment});
  }
}

AlignedBuffer new_buffer(std::size_t bytes) {
  if (bytes < kMinOfPool) {
    return AlignedBuffer(::operator new (bytes, std::align_val_t{kBufferAlignment}));
  }
  std::shared_ptr<BufferPool> pool = run_state().pool;
  if (pool == nullptr) pool = std::make_shared<BufferPool>(BufferPool::Kept::nothing);
  std::byte* const cells = pool->take(bytes);
  return {cells, BufferDeleter{std::move(pool)}};
}

BufferReuse::BufferReuse() {
  if (run_state().pool != nullptr) return;
  auto pool = std::make_shared<BufferPool>(BufferPool::Kept::for_the_next);
  change_ = std::make_unique<RunChange>(with_pool(run_state(), std::move(pool)));
}

BufferReuse::~BufferReuse() {
  if (change_ != nullptr) change_->state.pool->close();
}

}  // namespace xgm
