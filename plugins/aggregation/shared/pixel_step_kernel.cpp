// SPDX-License-Identifier: Apache-2.0
// The inner step in vectors. Cells are handled in blocks of 64, then 32, then 16 (as far as the
// vectors are that wide), so that a slice of whole granules has no rest. Up to four paths advance
// together: their minima, the only thing that one block waits for another with, are reduced at
// once.
#include <hwy/cache_control.h>

#include <cstring>

#include "plugins/aggregation/shared/advance.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/aggregation/shared/pixel_step_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

/// Extends with `Extend` at each pixel.
template <class Extend, class Cell>
void advance(PassWalk<Cell>& walk, Band<Cell>& band, int first, int last) {
  const int lag = walk.lag(), length = walk.frame().length(), count = band.count;
  for (int u = first; u < last; ++u) {
    for (int i = 0; i < count; ++i) {
      const int own = u - i * lag;
      if (own < 0 || own >= length) continue;
      WalkedLine<Cell>& line = band.lines[i];
      const WalkedPixel<Cell> pixel = walk.open(line, own);
      if (pixel.room > 0) Extend::extend(walk, line, pixel);
    }
  }
  // Before others hear of it.
  if (walk.step().past_caches) hwy::FlushStream();
}

struct Plainly {
  template <class Cell>
  static void extend(const PassWalk<Cell>& walk, const WalkedLine<Cell>& line,
                     const WalkedPixel<Cell>& pixel) {
    extend_plain(walk, line, pixel);
  }
};

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

template <class Cell>
Advance<Cell> choose(const PassStep&) {
  return advance<Plainly, Cell>;
}

#else

namespace hn = hwy::HWY_NAMESPACE;

/// Vectors of fewer lanes at the end of a slice give a minimum of all lanes, too.
template <class D, class Full>
HWY_INLINE hn::VFromD<Full> repeated(D d, Full full, hn::VFromD<D> v) {
  if constexpr (hn::MaxLanes(d) == hn::MaxLanes(full)) {
    return v;
  } else {
    const hn::Twice<D> twice;
    return repeated(twice, full, hn::Combine(twice, v, v));
  }
}

/// C in units of path costs, infinite where there is no match.
template <class D>
HWY_INLINE hn::VFromD<D> load_cost(D d, const std::uint8_t* cost, int bits) {
  if constexpr (sizeof(hn::TFromD<D>) == 1) {
    auto c = hn::LoadU(d, cost);
    for (int bit = 0; bit < bits; ++bit) c = hn::SaturatedAdd(c, c);  // 255 stays
    return c;
  } else {
    const auto c = hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), cost));
    const auto none = hn::Eq(c, hn::Set(d, CostVolume::kNoMatch));
    return hn::IfThenElse(none, hn::Set(d, kInfinite<std::uint16_t>), hn::ShiftLeftSame(c, bits));
  }
}

/// The same, infinite also from `count` on.
template <class D>
HWY_INLINE hn::VFromD<D> load_cost(D d, const std::uint8_t* cost, int bits, int count) {
  const auto c = load_cost(d, cost, bits);
  const int lanes = static_cast<int>(hn::MaxLanes(d));
  if (HWY_LIKELY(count >= lanes)) return c;
  const auto exists = hn::FirstN(d, static_cast<std::size_t>(count < 0 ? 0 : count));
  return hn::IfThenElse(exists, c, hn::Set(d, kInfinite<hn::TFromD<D> >));
}

/// The match classes of a block's disparities, from i on.
template <bool kClasses, class D>
HWY_INLINE hn::VFromD<D> load_classes(D d, const std::uint8_t* classes, int i) {
  if constexpr (!kClasses) {
    return hn::Zero(d);
  } else if constexpr (sizeof(hn::TFromD<D>) == 1) {
    return hn::LoadU(d, classes + i);
  } else {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), classes + i));
  }
}

/// The first lanes of v, as many as D has.
template <class D, class Full>
HWY_INLINE hn::VFromD<D> first_lanes(D d, Full full, hn::VFromD<Full> v) {
  if constexpr (hn::MaxLanes(d) == hn::MaxLanes(full)) {
    return v;
  } else {
    const hn::Half<Full> half;
    return first_lanes(d, half, hn::LowerHalf(half, v));
  }
}

/// A term in registers. Read from where it is, it would be read again after each path cost is
/// written: those are bytes, which for all a compiler knows could be anything's.
template <class D, bool kClasses>
class TermInRegisters {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE explicit TermInRegisters(const Term<Cell>& term)
      : previous_(term.previous),
        least_(hn::Set(D(), *term.least)),
        bit_(hn::Set(D(), static_cast<Cell>(1 << term.step))) {
    for (int i = 0; i < kTable; ++i) {
      p1_[i] = hn::Set(D(), term.penalties[i].p1);
      far_[i] = hn::SaturatedAdd(least_, hn::Set(D(), term.penalties[i].p2));
    }
  }

  template <class Block>
  HWY_INLINE hn::VFromD<Block> brought(Block d, hn::VFromD<Block> classes, int i) const {
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
    return hn::Sub(hn::Min(near, far), first_lanes(d, D(), least_));
  }

 private:
  static constexpr int kTable = kClasses ? 2 : 1;

  const Cell* previous_;
  hn::VFromD<D> least_, bit_, p1_[kTable], far_[kTable];
};

/// The mean, halves to even: AverageRound rounds them up, which is odd where it must not be.
template <class D>
HWY_INLINE hn::VFromD<D> mean(D d, hn::VFromD<D> a, hn::VFromD<D> b) {
  const auto up = hn::AverageRound(a, b);
  return hn::Sub(up, hn::And(hn::And(hn::Xor(a, b), up), hn::Set(d, 1)));
}

/// Sums of 16 bit of as many lanes as path costs have.
template <class D>
struct Sums {
  using Wide = hn::Repartition<std::uint16_t, D>;
  hn::VFromD<Wide> low, high;

  HWY_INLINE Sums() : low(hn::Zero(Wide())), high(hn::Zero(Wide())) {}

  HWY_INLINE void add(D d, hn::VFromD<D> brought) {
    if constexpr (sizeof(hn::TFromD<D>) == 1) {
      low = hn::Add(low, hn::PromoteTo(Wide(), hn::LowerHalf(hn::Half<D>(), brought)));
      high = hn::Add(high, hn::PromoteTo(Wide(), hn::UpperHalf(hn::Half<D>(), brought)));
    } else {
      low = hn::Add(low, brought);
    }
  }
  /// Saturating, so that kNoMatch stays.
  HWY_INLINE void add_to(std::uint16_t* sums) const {
    const Wide wide;
    hn::StoreU(hn::SaturatedAdd(low, hn::LoadU(wide, sums)), wide, sums);
    if constexpr (sizeof(hn::TFromD<D>) == 1) {
      sums += hn::MaxLanes(wide);
      hn::StoreU(hn::SaturatedAdd(high, hn::LoadU(wide, sums)), wide, sums);
    }
  }
  /// With the cost itself, kNoMatch where it is infinite.
  HWY_INLINE void begin(D d, hn::VFromD<D> cost, std::uint16_t weight, bool past_caches,
                        std::uint16_t* sums) const {
    const Wide wide;
    if constexpr (sizeof(hn::TFromD<D>) == 1) {
      const hn::Half<D> half;
      begin_wide(hn::PromoteTo(wide, hn::LowerHalf(half, cost)), low, CostVolume::kNoMatch, weight,
                 past_caches, sums);
      begin_wide(hn::PromoteTo(wide, hn::UpperHalf(half, cost)), high, CostVolume::kNoMatch, weight,
                 past_caches, sums + hn::MaxLanes(wide));
    } else {
      begin_wide(cost, low, kInfinite<std::uint16_t>, weight, past_caches, sums);
    }
    (void)d;
  }

 private:
  static HWY_INLINE void begin_wide(hn::VFromD<Wide> cost, hn::VFromD<Wide> brought,
                                    std::uint16_t infinite, std::uint16_t weight, bool past_caches,
                                    std::uint16_t* sums) {
    const Wide wide;
    const auto none = hn::Eq(cost, hn::Set(wide, infinite));
    const auto sum = hn::Add(hn::Mul(cost, hn::Set(wide, weight)), brought);
    const auto begun = hn::IfThenElse(none, hn::Set(wide, AggregatedVolume::kNoMatch), sum);
    if (past_caches) {
      hn::Stream(begun, wide, sums);
    } else {
      hn::StoreU(begun, wide, sums);
    }
  }
};

/// Lane by lane the least of both halves, and so on down to 16 bytes.
template <class D>
HWY_INLINE auto folded(D d, hn::VFromD<D> v) {
  if constexpr (hn::MaxLanes(d) * sizeof(hn::TFromD<D>) > 16) {
    const hn::Half<D> half;
    return folded(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    return v;
  }
}

/// Lane k is the least of v[k], for one, two or four vectors at once: interleaved, a vector of
/// minima holds those of all of them.
template <class Cell, int kVectors, class V>
HWY_INLINE hn::VFromD<hn::FixedTag<Cell, kVectors> > least_lanes(const V (&v)[kVectors]) {
  const hn::FixedTag<Cell, 16 / sizeof(Cell)> d;
  auto all = v[0];
  if constexpr (kVectors > 1) {
    all = hn::Min(hn::InterleaveLower(d, v[0], v[1]), hn::InterleaveUpper(d, v[0], v[1]));
  }
  if constexpr (kVectors > 2) {
    const auto other =
        hn::Min(hn::InterleaveLower(d, v[2], v[3]), hn::InterleaveUpper(d, v[2], v[3]));
    const hn::RepartitionToWide<decltype(d)> pairs;
    const auto a = hn::BitCast(pairs, all), b = hn::BitCast(pairs, other);
    all = hn::Min(hn::BitCast(d, hn::InterleaveLower(pairs, a, b)),
                  hn::BitCast(d, hn::InterleaveUpper(pairs, a, b)));
  }
  constexpr std::size_t kBytes = kVectors * sizeof(Cell);
  if constexpr (kBytes <= 8) all = hn::Min(all, hn::ShiftRightBytes<8>(d, all));
  if constexpr (kBytes <= 4) all = hn::Min(all, hn::ShiftRightBytes<4>(d, all));
  if constexpr (kBytes <= 2) all = hn::Min(all, hn::ShiftRightBytes<2>(d, all));
  if constexpr (kBytes <= 1) all = hn::Min(all, hn::ShiftRightBytes<1>(d, all));
  return first_lanes(hn::FixedTag<Cell, kVectors>(), d, all);
}

/// A path in registers.
template <class D, int kTerms, bool kClasses>
class PathInRegisters {
 public:
  using Cell = hn::TFromD<D>;

  /// `term` is the first one of those that the path has.
  HWY_INLINE PathInRegisters(const Term<Cell>* term, Cell* costs)
      : one_(term[0]),
        other_(term[kTerms - 1]),
        costs_(costs),
        least_(hn::Set(D(), kInfinite<Cell>)) {}

  /// Writes a block of path costs. Returns what the path brings.
  template <class Block>
  HWY_INLINE hn::VFromD<Block> extend(Block d, hn::VFromD<Block> cost, hn::VFromD<Block> classes,
                                      int i) {
    auto brought = one_.brought(d, classes, i);
    if constexpr (kTerms == 2) brought = mean(d, brought, other_.brought(d, classes, i));
    const auto extended = hn::SaturatedAdd(cost, brought);
    hn::StoreU(extended, d, costs_ + i);
    least_ = hn::Min(least_, repeated(d, D(), extended));
    return brought;
  }

  Cell* costs() const { return costs_; }
  HWY_INLINE auto folded_least() const { return folded(D(), least_); }

 private:
  TermInRegisters<D, kClasses> one_, other_;
  Cell* costs_;
  hn::VFromD<D> least_;
};

/// kPaths paths that advance together, in vectors of up to D's lanes.
template <class D, int kPaths, int kTerms, bool kClasses>
class Group {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE Group(const PassStep& pass, const WalkedPixel<Cell>& pixel, int first_path)
      : pass_(pass),
        pixel_(pixel),
        first_path_(first_path),
        begins_sums_(pass.first && first_path == 0),
        // What other paths are still added to had better stay.
        past_caches_(pass.past_caches && pass.paths == kPaths),
        pairs_fit_(sizeof(Cell) == 1 && 2 * pass.p2 <= kInfinite<Cell>) {}

  HWY_INLINE void run(const PassWalk<Cell>& walk, const WalkedLine<Cell>& line) {
    const auto terms = walk.template terms<kPaths, kTerms>(line, pixel_, first_path_);
    const auto path = [&](int k) HWY_ATTR {
      return PathInRegisters<D, kTerms, kClasses>(terms.data() + k * kTerms,
                                                  line.costs[first_path_ + k] + pixel_.first);
    };
    if constexpr (kPaths == 1) {
      run_paths(path(0));
    } else if constexpr (kPaths == 2) {
      run_paths(path(0), path(1));
    } else {
      run_paths(path(0), path(1), path(2), path(3));
    }
  }

 private:
  template <class... Paths>
  HWY_INLINE void run_paths(Paths... paths) {
    extend(D(), 0, paths...);
    const decltype(folded(D(), hn::Zero(D()))) folds[] = {paths.folded_least()...};
    (std::memset(paths.costs() + pixel_.room, 0xFF, VolumeShape::kGranule * sizeof(Cell)), ...);
    const hn::FixedTag<Cell, kPaths> d;
    const auto least = least_lanes<Cell>(folds);
    hn::StoreU(least, d, pixel_.least + first_path_);
    const auto with_p2 = hn::SaturatedAdd(least, hn::Set(d, static_cast<Cell>(pass_.p2)));
    const auto infinite = hn::Set(d, kInfinite<Cell>);
    const auto too_large = hn::AndNot(hn::Eq(least, infinite), hn::Eq(with_p2, infinite));
    if (HWY_UNLIKELY(!hn::AllFalse(d, too_large))) {
      int k = first_path_;
      (make_room(paths.costs(), pixel_.least[k++]), ...);
    }
  }

  HWY_INLINE void make_room(Cell* costs, Cell& least) const {
    if (!has_room_for_p2(least, pass_)) lower(costs, pixel_.room, least);
  }

  template <class Block, class... Paths>
  HWY_INLINE void extend(Block d, int i, Paths&... paths) {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(Block()));
    for (; i + kLanes <= pixel_.room; i += kLanes) extend_block(d, i, paths...);
    if constexpr (kLanes > VolumeShape::kGranule) extend(hn::Half<Block>(), i, paths...);
  }

  template <class Block, class... Paths>
  HWY_INLINE void extend_block(Block d, int i, Paths&... paths) {
    if (first_path_ == 0) prefetch(d, i);
    const auto cost = load_cost(d, pixel_.cost + i, pass_.bits, pixel_.count - i);
    const auto classes = load_classes<kClasses>(d, pixel_.classes, i);
    const hn::VFromD<Block> brought[kPaths] = {paths.extend(d, cost, classes, i)...};
    Sums<Block> sums;
    for (int k = 0; k < kPaths; ++k) {
      if (kPaths > 1 && pairs_fit_) {
        sums.add(d, hn::Add(brought[k], brought[k + 1]));
        ++k;
      } else {
        sums.add(d, brought[k]);
      }
    }
    if (begins_sums_) {
      sums.begin(d, cost, static_cast<std::uint16_t>(pass_.cost_weight), past_caches_,
                 pixel_.sums + i);
    } else {
      sums.add_to(pixel_.sums + i);
    }
  }

  template <class Block>
  HWY_INLINE void prefetch(Block, int i) const {
    constexpr std::size_t kCellsOfCacheLine = 64 / sizeof(std::uint16_t);
    hwy::Prefetch(pixel_.next_cost + i);
    if (past_caches_) return;
    for (std::size_t cell = 0; cell < hn::MaxLanes(Block()); cell += kCellsOfCacheLine)
      hwy::Prefetch(pixel_.next_sums + i + cell);
  }

  // Copies, for the reason that TermInRegisters gives.
  const PassStep pass_;
  const WalkedPixel<Cell> pixel_;
  int first_path_;
  bool begins_sums_, past_caches_, pairs_fit_;
};

/// All paths of a pixel in groups. Short slices in short vectors, whose minima are found sooner.
template <class Cell, int kGroup, int kTerms, bool kClasses>
struct InVectors {
  static HWY_INLINE void extend(const PassWalk<Cell>& walk, const WalkedLine<Cell>& line,
                                const WalkedPixel<Cell>& pixel) {
    const hn::CappedTag<Cell, 64 / sizeof(Cell)> widest;
    if constexpr (sizeof(Cell) == 1 && hn::MaxLanes(widest) > 32) {
      const hn::Half<decltype(widest)> half;
      if (pixel.room < 64) return extend_groups(half, walk, line, pixel);
    }
    extend_groups(widest, walk, line, pixel);
  }

 private:
  template <class D>
  static HWY_INLINE void extend_groups(D, const PassWalk<Cell>& walk, const WalkedLine<Cell>& line,
                                       const WalkedPixel<Cell>& pixel) {
    const int paths = walk.step().paths;
    for (int k = 0; k < paths; k += kGroup)
      Group<D, kGroup, kTerms, kClasses>(walk.step(), pixel, k).run(walk, line);
  }
};

template <class Cell, int kTerms, bool kClasses>
Advance<Cell> choose_group(int paths) {
  // Four paths of two terms do not fit the registers.
  if constexpr (kTerms == 1) {
    if (paths % 4 == 0) return advance<InVectors<Cell, 4, kTerms, kClasses>, Cell>;
  }
  if (paths % 2 == 0) return advance<InVectors<Cell, 2, kTerms, kClasses>, Cell>;
  return advance<InVectors<Cell, 1, kTerms, kClasses>, Cell>;
}

template <class Cell, int kTerms>
Advance<Cell> choose_classes(const PassStep& pass) {
  return pass.match_classes == 1 ? choose_group<Cell, kTerms, false>(pass.paths)
                                 : choose_group<Cell, kTerms, true>(pass.paths);
}

template <class Cell>
Advance<Cell> choose(const PassStep& pass) {
  if (pass.class_plane != 0) return advance<Plainly, Cell>;
  return pass.terms == 1 ? choose_classes<Cell, 1>(pass) : choose_classes<Cell, 2>(pass);
}

#endif

Advance<std::uint8_t> choose_8(const PassStep& pass) { return choose<std::uint8_t>(pass); }
Advance<std::uint16_t> choose_16(const PassStep& pass) { return choose<std::uint16_t>(pass); }

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::aggregation {

HWY_EXPORT(choose_8);
HWY_EXPORT(choose_16);

template <>
Advance<std::uint8_t> choose_advance(const PassStep& pass) {
  return HWY_DYNAMIC_DISPATCH(choose_8)(pass);
}
template <>
Advance<std::uint16_t> choose_advance(const PassStep& pass) {
  return HWY_DYNAMIC_DISPATCH(choose_16)(pass);
}

}  // namespace xgm::aggregation
#endif
