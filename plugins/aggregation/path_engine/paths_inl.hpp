// SPDX-License-Identifier: Apache-2.0
// Paths and terms in registers, for the SIMD target that is being compiled.
#if defined(XGM_AGGREGATION_PATHS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef XGM_AGGREGATION_PATHS_INL_HPP
#undef XGM_AGGREGATION_PATHS_INL_HPP
#else
#define XGM_AGGREGATION_PATHS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "plugins/aggregation/path_engine/blocks_inl.hpp"
#include "plugins/aggregation/path_engine/pass_walk.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

/// A term in registers. Read from where it is, it would be read again after each path cost is
/// written: those are bytes, which for all a compiler knows could be anything's.
template <class D, bool kClasses>
class TermInRegisters {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE explicit TermInRegisters(const Term<Cell>& term)
      : previous_(term.previous),
        min_(filled(D(), *term.minimum)),
        bit_(hn::Set(D(), static_cast<Cell>(1 << term.step))) {
    for (int i = 0; i < kTable; ++i) {
      p1_[i] = filled(D(), term.penalties[i].p1);
      far_[i] = hn::SaturatedAdd(min_, filled(D(), term.penalties[i].p2));
    }
  }

  template <class Block>
  HWY_INLINE hn::VFromD<Block> message(Block d, hn::VFromD<Block> classes, int i) const {
    const Cell* const at = previous_ + i;
    auto p1 = first_lanes(d, D(), p1_[0]);
    auto far = first_lanes(d, D(), far_[0]);
    if constexpr (kClasses) {
      const auto second = hn::TestBit(classes, first_lanes(d, D(), bit_));
      p1 = hn::IfThenElse(second, first_lanes(d, D(), p1_[1]), p1);
      far = hn::IfThenElse(second, first_lanes(d, D(), far_[1]), far);
    }
    const auto beside = hn::Min(hn::LoadU(d, at - 1), hn::LoadU(d, at + 1));
    const auto near = hn::Min(hn::LoadU(d, at), hn::SaturatedAdd(beside, p1));
    return hn::Sub(hn::Min(near, far), first_lanes(d, D(), min_));
  }

 private:
  static constexpr int kTable = kClasses ? 2 : 1;

  const Cell* previous_;
  hn::VFromD<D> min_, bit_, p1_[kTable], far_[kTable];
};

/// A path in registers.
template <class D, int kTerms, bool kClasses>
class PathInRegisters {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE PathInRegisters(const Term<Cell>& one, const Term<Cell>& other, Cell* costs)
      : one_(one), other_(other), costs_(costs), min_(hn::Set(D(), kInfinite<Cell>)) {}

  /// Writes a block of path costs. Returns what the path brings.
  template <class Block>
  HWY_INLINE hn::VFromD<Block> extend(Block d, hn::VFromD<Block> cost, hn::VFromD<Block> classes,
                                      int i) {
    auto message = one_.message(d, classes, i);
    if constexpr (kTerms == 2) message = mean(d, message, other_.message(d, classes, i));
    const auto extended = hn::SaturatedAdd(cost, message);
    hn::StoreU(extended, d, costs_ + i);
    min_ = hn::Min(min_, repeated(d, D(), extended));
    return message;
  }

  Cell* costs() const { return costs_; }
  HWY_INLINE hn::VFromD<D> minimum() const { return min_; }

 private:
  TermInRegisters<D, kClasses> one_, other_;
  Cell* costs_;
  hn::VFromD<D> min_;
};

/// The terms of most pixels: step `step` at element k of the layout.
template <int kAllPaths, int kTerms, bool kClasses, class Cell>
HWY_INLINE Term<Cell> usual_term(const WalkedLine<Cell>& line, int k, int step) {
  const std::ptrdiff_t u = line.layout.first + k;
  return {line.back_costs[step] + line.layout.back[step][k],
          line.back[step].minimum + u * kAllPaths + step / kTerms, step,
          line.penalties + step * (kClasses ? 2 : 1)};
}

/// Where the minima of all paths are stored at element k of the layout.
template <int kAllPaths, class Cell>
HWY_INLINE Repeated* minima_of(const WalkedLine<Cell>& line, int k) {
  return line.pixels.minimum + std::ptrdiff_t{line.layout.first + k} * kAllPaths;
}

/// Whether the messages of two paths can be added in the width of path costs.
template <class Cell>
HWY_INLINE bool pairs_fit(const PassStep& pass) {
  return sizeof(Cell) == 1 && 2 * pass.p2 <= kInfinite<Cell>;
}

/// Stores lanes 0 to kCount - 1 of `minima`, 16 bytes, as the minima of the paths whose `costs` are
/// given. Makes room for P2 where there is none.
template <int kCount, class Cell, class V>
HWY_INLINE void store_minima(const PassStep& pass, V minima, Cell* const* costs, int room,
                             Repeated* to) {
  store_repeated<kCount>(minima, to);
  if (pass.always_room) return;
  const hn::FixedTag<Cell, 16 / sizeof(Cell)> d;
  const hn::FixedTag<Cell, kCount> few;
  const auto minimum = first_lanes(few, d, minima);
  const auto with_p2 = hn::SaturatedAdd(minimum, hn::Set(few, static_cast<Cell>(pass.p2)));
  const auto infinite = hn::Set(few, kInfinite<Cell>);
  const auto too_large = hn::AndNot(hn::Eq(minimum, infinite), hn::Eq(with_p2, infinite));
  if (HWY_LIKELY(hn::AllFalse(few, too_large))) return;
  for (int p = 0; p < kCount; ++p) {
    const Cell cost = to[p].template as<Cell>();
    if (has_room_for_p2(cost, pass)) continue;
    lower(costs[p], room, cost);
    to[p] = Repeated();
  }
}

#endif

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
