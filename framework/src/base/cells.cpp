// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/cells.hpp"

#include <cstdint>
#include <mutex>
#include <new>

#include "base/block_pool.hpp"

namespace xgm {
namespace {

// What the system grants in huge pages; less is not worth a system call.
constexpr std::size_t kLeastOfPool = 4 * kHugePage;

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

void CellsDeleter::operator()(void* cells) const {
  if (bytes < kLeastOfPool) {
    ::operator delete (cells, std::align_val_t{kCellAlignment});
    return;
  }
  SharedPool& shared = pool();
  const std::scoped_lock lock(shared.mutex);
  shared.blocks.give_back(static_cast<std::byte*>(cells));
  if (shared.users == 0) shared.blocks.trim();
}

Cells new_cells(std::size_t bytes) {
  if (bytes < kLeastOfPool) {
    return Cells(::operator new (bytes, std::align_val_t{kCellAlignment}), {bytes});
  }
  SharedPool& shared = pool();
  const std::scoped_lock lock(shared.mutex);
  return Cells(shared.blocks.take(bytes), {bytes});
}

CellReuse::CellReuse() {
  const std::scoped_lock lock(pool().mutex);
  ++pool().users;
}

CellReuse::~CellReuse() {
  const std::scoped_lock lock(pool().mutex);
  if (--pool().users == 0) pool().blocks.trim();
}

}  // namespace xgm
