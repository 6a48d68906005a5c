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

/// Gives memory to reserved addresses; false if there is none.
bool populate(std::byte* place, std::size_t bytes) {
  // Not mapped anew: that would evade the limit of data (RLIMIT_DATA).
  if (mprotect(place, bytes, PROT_READ | PROT_WRITE) != 0) return false;
  madvise(place, bytes, MADV_HUGEPAGE);  // a wish: without huge pages it works, too
  return true;
}

}  // namespace

std::byte* BlockPool::take(std::size_t bytes) {
  const std::size_t whole = whole_pages(bytes);
  std::byte* const place = reserve(whole);
  if (place == nullptr) throw std::bad_alloc();
  std::vector<Piece> block;
  const std::size_t filled = fill(place, whole, block);
  const std::size_t fresh = whole - filled;
  if (fresh > 0) {
    bool there = populate(place + filled, fresh);
    if (!there) {
      trim();
      there = populate(place + filled, fresh);
    }
    if (!there) {
      munmap(place, whole);
      throw std::bad_alloc();
    }
    block.push_back({place + filled, fresh});
  }
  blocks_.emplace(place, std::move(block));
  used_ += whole;
  max_used_ = std::max(max_used_, used_);
  if (used_ + kept_bytes_ > max_used_) drop(used_ + kept_bytes_ - max_used_);
  return place;
}

void BlockPool::give_back(std::byte* block) {
  const auto found = blocks_.find(block);
  for (const Piece piece : found->second) {
    used_ -= piece.bytes;
    keep(piece);
  }
  blocks_.erase(found);
}

void BlockPool::trim() {
  drop(kept_bytes_);
  max_used_ = used_;
}

/// Moves kept pieces to `place` until it is full or none is left. Returns how many bytes they are.
std::size_t BlockPool::fill(std::byte* place, std::size_t bytes, std::vector<Piece>& block) {
  std::size_t filled = 0;
  while (filled < bytes && !kept_.empty()) {
    Piece piece = pick(bytes - filled);
    if (piece.bytes > bytes - filled) {
      keep({piece.begin + (bytes - filled), piece.bytes - (bytes - filled)});
      piece.bytes = bytes - filled;
    }
    void* const moved = mremap(piece.begin, piece.bytes, piece.bytes, MREMAP_MAYMOVE | MREMAP_FIXED,
                               place + filled);
    if (moved == MAP_FAILED) {  // too many mappings
      munmap(piece.begin, piece.bytes);
      break;
    }
    block.push_back({place + filled, piece.bytes});
    filled += piece.bytes;
  }
  return filled;
}

/// The smallest kept piece of at least so many bytes, else the largest.
BlockPool::Piece BlockPool::pick(std::size_t bytes) {
  const auto better = [bytes](Piece a, Piece b) {
    const bool a_fits = a.bytes >= bytes, b_fits = b.bytes >= bytes;
    if (a_fits != b_fits) return a_fits;
    return a_fits ? a.bytes < b.bytes : a.bytes > b.bytes;
  };
  const auto best = std::min_element(kept_.begin(), kept_.end(), better);
  const Piece piece = *best;
  kept_.erase(best);
  kept_bytes_ -= piece.bytes;
  return piece;
}

void BlockPool::keep(Piece piece) {
  kept_.push_back(piece);
  kept_bytes_ += piece.bytes;
}

void BlockPool::drop(std::size_t bytes) {
  while (bytes > 0) {
    Piece& piece = kept_.back();
    const std::size_t cut = std::min(piece.bytes, bytes);
    piece.bytes -= cut;
    munmap(piece.begin + piece.bytes, cut);
    kept_bytes_ -= cut;
    bytes -= cut;
    if (piece.bytes == 0) kept_.pop_back();
  }
}

}  // namespace xgm
