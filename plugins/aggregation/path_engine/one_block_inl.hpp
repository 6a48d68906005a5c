// SPDX-License-Identifier: Apache-2.0
// The inner step for slices that fit one vector, as most slices of pyramids do.
#if defined(XGM_AGGREGATION_ONE_BLOCK_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef XGM_AGGREGATION_ONE_BLOCK_INL_HPP
#undef XGM_AGGREGATION_ONE_BLOCK_INL_HPP
#else
#define XGM_AGGREGATION_ONE_BLOCK_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

#include "plugins/aggregation/path_engine/paths_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

/// Extends all paths of the usual pixel at element k of the layout, whose slice has exactly as many
/// cells as D has lanes, or fewer if kPart.
template <class D, bool kPart, int kPaths, int kTerms, bool kClasses>
class OneBlock {
 public:
  using Cell = hn::TFromD<D>;

  static HWY_INLINE void extend(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k) {
    const D d;
    const PassStep& pass = walk.step();
    const LineLayout& layout = line.layout;
    const int room = kPart ? layout.room[k] : kLanes<D>;
    prefetch(walk, layout.offset[k + LineLayout::kAhead]);
    const auto cost =
        load_part_of_cost(d, walk.costs() + layout.offset[k], pass.bits, layout.count[k]);
    const std::uint8_t* const at =
        kClasses ? walk.match_classes(line, layout.first + k, layout.begin[k]) : nullptr;
    const auto classes = load_classes<kClasses>(d, at, 0);
    Paths paths;
    extend_from<0>(line, k, {cost, classes, room, pairs_fit<Cell>(pass)}, paths);
    std::uint16_t* const to = walk.sums() + layout.offset[k];
    if (line.begins_sums) {
      const auto weight = static_cast<std::uint16_t>(pass.cost_weight);
      paths.sums.begin(d, cost, weight, pass.past_caches, to, room);
    } else {
      paths.sums.add_to(to, room);
    }
    store_from<0>(pass, paths, room, minima_of<kPaths>(line, k));
  }

 private:
  static constexpr int kPair = kPaths < 2 ? kPaths : 2;
  static constexpr int kStored = kPaths < 4 ? kPaths : 4;

  /// What all paths of the pixel read.
  struct Read {
    hn::VFromD<D> cost, classes;
    int room;
    bool pairs_fit;
  };
  /// What they leave. Indices are known at compile time, so that all of it is in registers.
  struct Paths {
    HWY_INLINE Paths() {}

    Sums<D> sums;
    hn::VFromD<D> minima[kPaths];
    Cell* costs[kPaths];
  };

  /// Extends the paths from kFirst on.
  template <int kFirst>
  static HWY_INLINE void extend_from(const WalkedLine<Cell>& line, int k, const Read& read,
                                     Paths& paths) {
    if constexpr (kFirst < kPaths) {
      const D d;
      const auto message = extend_path<kFirst>(line, k, read, paths);
      if constexpr (kPair == 1) {
        paths.sums.add(d, message);
      } else {
        const auto other = extend_path<kFirst + kPair - 1>(line, k, read, paths);
        if (read.pairs_fit) {
          paths.sums.add(d, hn::Add(message, other));
        } else {
          paths.sums.add(d, message);
          paths.sums.add(d, other);
        }
      }
      extend_from<kFirst + kPair>(line, k, read, paths);
    }
  }

  /// Writes the path costs of path kPath. Returns its message.
  template <int kPath>
  static HWY_INLINE hn::VFromD<D> extend_path(const WalkedLine<Cell>& line, int k, const Read& read,
                                              Paths& paths) {
    constexpr int kStep = kPath * kTerms;
    Cell* const costs = line.costs[kPath] + line.layout.own[k];
    PathInRegisters<D, kTerms, kClasses> path(
        usual_term<kPaths, kTerms, kClasses>(line, k, kStep),
        usual_term<kPaths, kTerms, kClasses>(line, k, kStep + kTerms - 1), costs);
    const auto message = path.extend(D(), read.cost, read.classes, 0);
    std::memset(costs + read.room, 0xFF, VolumeShape::kGranule * sizeof(Cell));
    paths.costs[kPath] = costs;
    paths.minima[kPath] = path.minimum();
    return message;
  }

  /// Stores the minima of the paths from kFirst on.
  template <int kFirst>
  static HWY_INLINE void store_from(const PassStep& pass, const Paths& paths, int room,
                                    Repeated* to) {
    if constexpr (kFirst < kPaths) {
      store_minima<kStored>(pass, least_from<kFirst>(paths), paths.costs + kFirst, room,
                            to + kFirst);
      store_from<kFirst + kStored>(pass, paths, room, to);
    }
  }
  template <int kFirst>
  static HWY_INLINE auto least_from(const Paths& paths) {
    const auto* const minima = paths.minima + kFirst;
    if constexpr (kStored == 1) {
      return min_lanes(D(), minima[0]);
    } else if constexpr (kStored == 2) {
      return min_lanes(D(), minima[0], minima[1]);
    } else {
      return min_lanes(D(), minima[0], minima[1], minima[2], minima[3]);
    }
  }

  static HWY_INLINE void prefetch(const PassWalk<Cell>& walk, std::int64_t next) {
    constexpr int kCellsOfCacheLine = 64 / sizeof(std::uint16_t);
    hwy::Prefetch(walk.costs() + next);
    for (int i = 0; i < kLanes<D>; i += kCellsOfCacheLine) hwy::Prefetch(walk.sums() + next + i);
  }
};

/// Extends all paths of the usual pixel at element k of the layout if its slice fits one vector;
/// false if not. Such slices are most of a pyramid's. Each value is used once there, so that paths
/// are extended one after the other without keeping terms in registers, and all of them share what
/// there is to do for a pixel.
template <int kPaths, int kTerms, bool kClasses, class Cell>
HWY_INLINE bool extend_one_block(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k) {
  constexpr int kGranule = VolumeShape::kGranule;
  constexpr int kWidest = kLanes<hn::CappedTag<Cell, 64 / sizeof(Cell)> >;
  const int room = line.layout.room[k];
  if constexpr (kWidest >= kGranule) {
    if (room == kGranule) {
      using D = hn::CappedTag<Cell, kGranule>;
      OneBlock<D, false, kPaths, kTerms, kClasses>::extend(walk, line, k);
      return true;
    }
  }
  if constexpr (kWidest >= 2 * kGranule) {
    if (room == 2 * kGranule) {
      using D = hn::CappedTag<Cell, 2 * kGranule>;
      OneBlock<D, false, kPaths, kTerms, kClasses>::extend(walk, line, k);
      return true;
    }
  }
  if constexpr (kMasks && kWidest >= 4 * kGranule) {
    if (room <= 4 * kGranule) {
      using D = hn::CappedTag<Cell, 4 * kGranule>;
      OneBlock<D, true, kPaths, kTerms, kClasses>::extend(walk, line, k);
      return true;
    }
  }
  return false;
}

#endif

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
