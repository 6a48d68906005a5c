// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/aligned_buffer.hpp"

#include <cstdint>
#include <mutex>
#include <new>

#include "base/block_pool.hpp"

namespace xgm {
namespace {

// What the system grants in huge pages; less is not worth a system call.
constexpr std::size_t kMinOfPool = 4 * kHugePage;

/// Never destroyed: volumes may outlive all static objects.
struct SharedPool {
  std::mutex mutex;
  BlockPool blocks;
  int users = 0;
};
SharedPool& pool() {
  static SharedPool& shared = *new SharedPool;
  return shared;
}

}  // namespace

void BufferDeleter::operator()(void* cells) const {
  if (bytes < kMinOfPool) {
    ::operator delete (cells, std::align_val_t{kBufferAlignment});
    return;
  }
  SharedPool& shared = pool();
  const std::scoped_lock lock(shared.mutex);
  shared.blocks.give_back(static_cast<std::byte*>(cells));
  if (shared.users == 0) shared.blocks.trim();
}

AlignedBuffer new_buffer(std::size_t bytes) {
  if (bytes < kMinOfPool) {
    return AlignedBuffer(::operator new (bytes, std::align_val_t{kBufferAlignment}), {bytes});
  }
  SharedPool& shared = pool();
  const std::scoped_lock lock(shared.mutex);
  return AlignedBuffer(shared.blocks.take(bytes), {bytes});
}

BufferReuse::BufferReuse() {
  const std::scoped_lock lock(pool().mutex);
  ++pool().users;
}

BufferReuse::~BufferReuse() {
  const std::scoped_lock lock(pool().mutex);
  if (--pool().users == 0) pool().blocks.trim();
}

}  // namespace xgm
