// SPDX-License-Identifier: Apache-2.0
#include "base/block_pool.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace xgm {
namespace {

std::size_t whole_pages(std::size_t bytes) {
  if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
  return (bytes + kHugePage - 1) / kHugePage * kHugePage;
}

std::size_t distance(std::size_t a, std::size_t b) { return a < b ? b - a : a - b; }

/// Addresses without memory, aligned to huge pages; null if there are none.
std::byte* reserve(std::size_t bytes) {
  const std::size_t room = bytes + kHugePage;
  void* const found = mmap(nullptr, room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (found == MAP_FAILED) return nullptr;
  auto* const all = static_cast<std::byte*>(found);
  const std::size_t before =
      (kHugePage - reinterpret_cast<std::uintptr_t>(all) % kHugePage) % kHugePage;
  if (before > 0) munmap(all, before);
  munmap(all + before + bytes, room - before - bytes);
  return all + before;
}

/// A new block; null if there is no memory.
std::byte* map(std::size_t bytes) {
  std::byte* const block = reserve(bytes);
  if (block == nullptr) return nullptr;
  // Not mapped anew: that would evade the limit of data (RLIMIT_DATA).
  if (mprotect(block, bytes, PROT_READ | PROT_WRITE) != 0) {
    munmap(block, bytes);
    return nullptr;
  }
  madvise(block, bytes, MADV_HUGEPAGE);  // a wish: without huge pages it works, too
  return block;
}

/// Makes a block larger, and keeps its pages; null, with the block as it was, if there is no
/// memory.
std::byte* grow(Block block, std::size_t bytes) {
  std::byte* const place = reserve(bytes);  // moved, for what lies behind the block may be in use
  if (place == nullptr) return nullptr;
  void* const moved = mremap(block.begin, block.bytes, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, place);
  // If that failed, the place may be another's already, so that it is not ours to unmap.
  return moved == MAP_FAILED ? nullptr : place;
}

}  // namespace

std::byte* BlockPool::take(std::size_t bytes) {
  const std::size_t whole = whole_pages(bytes);
  std::byte* begin = nullptr;
  if (const Block block = take_free(whole); block.begin != nullptr) {
    begin = fit(block, whole);
    if (begin == nullptr) munmap(block.begin, block.bytes);
  }
  if (begin == nullptr) begin = map(whole);
  if (begin == nullptr) {
    trim();
    begin = map(whole);
  }
  if (begin == nullptr) throw std::bad_alloc();
  used_ += whole;
  most_used_ = std::max(most_used_, used_);
  drop_surplus();
  return begin;
}

void BlockPool::give_back(Block block) {
  block.bytes = whole_pages(block.bytes);
  used_ -= block.bytes;
  add_free(block);
}

void BlockPool::trim() {
  for (const Block& block : free_) munmap(block.begin, block.bytes);
  free_.clear();
  free_bytes_ = 0;
  most_used_ = used_;
}

/// Joined with free neighbours, so that what was split becomes whole again. (Neighbours by chance
/// cannot grow together: the system refuses that, and a new block is made.)
void BlockPool::add_free(Block block) {
  free_bytes_ += block.bytes;
  std::erase_if(free_, [&](Block other) {
    if (other.begin + other.bytes == block.begin) {
      block.begin = other.begin;
    } else if (block.begin + block.bytes != other.begin) {
      return false;
    }
    block.bytes += other.bytes;
    return true;
  });
  free_.push_back(block);
}

/// `block` with so many bytes; what it has too much stays free. Null, with the block as it was, if
/// there is no memory.
std::byte* BlockPool::fit(Block block, std::size_t bytes) {
  if (block.bytes < bytes) return grow(block, bytes);
  if (block.bytes > bytes) add_free({block.begin + bytes, block.bytes - bytes});
  return block.begin;
}

/// The free block whose size is nearest; an empty one if there is none.
Block BlockPool::take_free(std::size_t bytes) {
  const auto nearest = std::min_element(free_.begin(), free_.end(), [&](Block a, Block b) {
    return distance(a.bytes, bytes) < distance(b.bytes, bytes);
  });
  if (nearest == free_.end()) return {};
  const Block block = *nearest;
  free_.erase(nearest);
  free_bytes_ -= block.bytes;
  return block;
}

void BlockPool::drop_surplus() {
  while (!free_.empty() && used_ + free_bytes_ > most_used_) {
    const auto smallest = std::min_element(free_.begin(), free_.end(),
                                           [](Block a, Block b) { return a.bytes < b.bytes; });
    const std::size_t cut = std::min(smallest->bytes, used_ + free_bytes_ - most_used_);
    smallest->bytes -= cut;
    free_bytes_ -= cut;
    munmap(smallest->begin + smallest->bytes, cut);
    if (smallest->bytes == 0) free_.erase(smallest);
  }
}

}  // namespace xgm
