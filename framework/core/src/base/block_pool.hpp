// SPDX-License-Identifier: Apache-2.0
// Blocks of memory straight from the system, in huge pages, and those that wait to be used again.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Getting memory takes longer than to fill it: the system clears every page first. So what is
/// given back is kept, in pieces, of which the next block is put together: the system moves pages
/// to any address without touching them. Kept pieces are dropped as soon as these and the used
/// blocks together exceed what was once in use, so that the pool never makes a program larger than
/// it would be without. Not safe for several threads.
class XGM_API BlockPool {
 public:
  BlockPool() = default;
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;
  ~BlockPool() { trim(); }

  /// Throws std::bad_alloc if there is no such memory, even without the kept pieces.
  std::byte* take(std::size_t bytes);
  /// `block` is one that take() gave.
  void give_back(std::byte* block);
  /// Returns all kept pieces to the system.
  void trim();

  /// Whole huge pages.
  std::size_t used_bytes() const { return used_; }
  std::size_t kept_bytes() const { return kept_bytes_; }

 private:
  struct Piece {
    std::byte* begin = nullptr;
    std::size_t bytes = 0;
  };

  std::size_t fill(std::byte* place, std::size_t bytes, std::vector<Piece>& block);
  Piece pick(std::size_t bytes);
  void keep(Piece piece);
  void drop(std::size_t bytes);

  std::unordered_map<std::byte*, std::vector<Piece>> blocks_;
  std::vector<Piece> kept_;
  std::size_t used_ = 0, kept_bytes_ = 0;
  std::size_t max_used_ = 0;  // since the last trim
};

}  // namespace xgm
