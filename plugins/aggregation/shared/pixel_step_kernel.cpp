// SPDX-License-Identifier: Apache-2.0
// The inner step in vectors. Cells are handled in blocks of 64, then 32, then 16 (as far as the
// vectors are that wide), so that a slice of whole granules has no rest. Up to four paths advance
// together: their minima, the only thing that one block waits for another with, are reduced at
// once.
#include <hwy/cache_control.h>

#include <cstring>

#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/data/volume.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/aggregation/shared/pixel_step_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

template <class Cell>
ExtendPaths<Cell> choose(const PassStep&) {
  return extend_paths_plain<Cell>;
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

/// P1 or P2 of each disparity.
template <bool kClasses, class D, class Mask>
HWY_INLINE hn::VFromD<D> penalties(D d, const hn::TFromD<D>* by_class, Mask second) {
  if constexpr (kClasses) {
    return hn::IfThenElse(second, hn::Set(d, by_class[1]), hn::Set(d, by_class[0]));
  } else {
    return hn::Set(d, by_class[0]);
  }
}

/// Where the match class is 1.
template <class D>
HWY_INLINE hn::MFromD<D> second_class(D d, const std::uint8_t* classes) {
  if constexpr (sizeof(hn::TFromD<D>) == 1) {
    return hn::Ne(hn::LoadU(d, classes), hn::Zero(d));
  } else {
    return hn::Ne(hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), classes)), hn::Zero(d));
  }
}

template <bool kClasses, class D>
HWY_INLINE hn::VFromD<D> brought_by(D d, const Term<hn::TFromD<D> >& term, int i) {
  auto second = hn::FirstN(d, 0);
  if constexpr (kClasses) second = second_class(d, term.classes + i);
  const auto* const at = term.previous + i;
  const auto beside = hn::Min(hn::LoadU(d, at - 1), hn::LoadU(d, at + 1));
  const auto near = hn::SaturatedAdd(beside, penalties<kClasses>(d, term.p1, second));
  const auto far = penalties<kClasses>(d, term.p2, second);
  return hn::Min(hn::Min(hn::LoadU(d, at), near), far);
}

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
  HWY_INLINE void begin(D d, hn::VFromD<D> cost, std::uint16_t weight, std::uint16_t* sums) const {
    const Wide wide;
    if constexpr (sizeof(hn::TFromD<D>) == 1) {
      const hn::Half<D> half;
      begin_wide(hn::PromoteTo(wide, hn::LowerHalf(half, cost)), low, CostVolume::kNoMatch, weight,
                 sums);
      begin_wide(hn::PromoteTo(wide, hn::UpperHalf(half, cost)), high, CostVolume::kNoMatch, weight,
                 sums + hn::MaxLanes(wide));
    } else {
      begin_wide(cost, low, kInfinite<std::uint16_t>, weight, sums);
    }
    (void)d;
  }

 private:
  static HWY_INLINE void begin_wide(hn::VFromD<Wide> cost, hn::VFromD<Wide> brought,
                                    std::uint16_t infinite, std::uint16_t weight,
                                    std::uint16_t* sums) {
    const Wide wide;
    const auto none = hn::Eq(cost, hn::Set(wide, infinite));
    const auto sum = hn::Add(hn::Mul(cost, hn::Set(wide, weight)), brought);
    hn::StoreU(hn::IfThenElse(none, hn::Set(wide, AggregatedVolume::kNoMatch), sum), wide, sums);
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

/// least[k] = the least lane of v[k], for one, two or four vectors at once: interleaved, a vector
/// of minima holds those of all of them.
template <class Cell, int kVectors, class V>
HWY_INLINE void least_lanes(const V (&v)[kVectors], Cell (&least)[kVectors]) {
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
  alignas(16) Cell lanes[16 / sizeof(Cell)];
  hn::Store(all, d, lanes);
  for (int k = 0; k < kVectors; ++k) least[k] = lanes[k];
}

/// kPaths paths that advance together, in vectors of up to D's lanes.
template <class D, int kPaths, int kTerms, bool kClasses>
class Group {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE Group(const PassStep& pass, const PixelStep<Cell>& pixel, int first_path)
      : pass_(pass),
        pixel_(pixel),
        paths_(pixel.paths + first_path),
        begins_sums_(pass.first && first_path == 0),
        prefetches_(first_path == 0) {
    for (int k = 0; k < kPaths; ++k) least_[k] = hn::Set(D(), kInfinite<Cell>);
  }

  HWY_INLINE bool run() {
    extend(D(), 0);
    decltype(folded(D(), least_[0])) folds[kPaths];
    for (int k = 0; k < kPaths; ++k) folds[k] = folded(D(), least_[k]);
    Cell least[kPaths];
    least_lanes(folds, least);
    for (int k = 0; k < kPaths; ++k) {
      subtract(D(), 0, paths_[k].costs, least[k]);
      std::memset(paths_[k].costs + pixel_.room, 0xFF, VolumeShape::kGranule * sizeof(Cell));
    }
    return least[0] != kInfinite<Cell>;
  }

 private:
  template <class Block>
  HWY_INLINE void extend(Block d, int i) {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(Block()));
    for (; i + kLanes <= pixel_.room; i += kLanes) extend_block(d, i);
    if constexpr (kLanes > VolumeShape::kGranule) extend(hn::Half<Block>(), i);
  }

  template <class Block>
  HWY_INLINE void extend_block(Block d, int i) {
    if (prefetches_) prefetch(d, i);
    const auto cost = load_cost(d, pixel_.cost + i, pass_.bits, pixel_.count - i);
    Sums<Block> sums;
    for (int k = 0; k < kPaths; ++k) {
      auto brought = brought_by<kClasses>(d, paths_[k].terms[0], i);
      if constexpr (kTerms == 2) {
        brought = mean(d, brought, brought_by<kClasses>(d, paths_[k].terms[1], i));
      }
      const auto extended = hn::SaturatedAdd(cost, brought);
      hn::StoreU(extended, d, paths_[k].costs + i);
      least_[k] = hn::Min(least_[k], repeated(d, D(), extended));
      sums.add(d, brought);
    }
    if (begins_sums_) {
      sums.begin(d, cost, static_cast<std::uint16_t>(pass_.cost_weight), pixel_.sums + i);
    } else {
      sums.add_to(pixel_.sums + i);
    }
  }

  /// Passes that go backwards or along columns are no pattern that processors foresee.
  template <class Block>
  HWY_INLINE void prefetch(Block, int i) const {
    constexpr std::size_t kCellsOfCacheLine = 64 / sizeof(std::uint16_t);
    hwy::Prefetch(pixel_.next_cost + i);
    for (std::size_t cell = 0; cell < hn::MaxLanes(Block()); cell += kCellsOfCacheLine)
      hwy::Prefetch(pixel_.next_sums + i + cell);
  }

  template <class Block>
  HWY_INLINE void subtract(Block d, int i, Cell* costs, Cell least) {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(Block()));
    const auto infinite = hn::Set(d, kInfinite<Cell>);
    const auto subtrahend = hn::Set(d, least);
    for (; i + kLanes <= pixel_.room; i += kLanes) {
      const auto cost = hn::LoadU(d, costs + i);
      hn::StoreU(hn::IfThenElse(hn::Eq(cost, infinite), cost, hn::Sub(cost, subtrahend)), d,
                 costs + i);
    }
    if constexpr (kLanes > VolumeShape::kGranule) subtract(hn::Half<Block>(), i, costs, least);
  }

  const PassStep& pass_;
  const PixelStep<Cell>& pixel_;
  const Extension<Cell>* paths_;
  bool begins_sums_, prefetches_;
  hn::VFromD<D> least_[kPaths];
};

template <class D, int kGroup, int kTerms, bool kClasses, class Cell>
HWY_INLINE bool extend_groups(D, const PassStep& pass, const PixelStep<Cell>& pixel) {
  bool finite = false;
  for (int k = 0; k < pass.paths; k += kGroup)
    finite = Group<D, kGroup, kTerms, kClasses>(pass, pixel, k).run();
  return finite;
}

/// Short slices in short vectors, whose minima are found sooner.
template <class Cell, int kGroup, int kTerms, bool kClasses>
bool extend_paths(const PassStep& pass, const PixelStep<Cell>& pixel) {
  const hn::CappedTag<Cell, 64 / sizeof(Cell)> widest;
  if constexpr (sizeof(Cell) == 1 && hn::MaxLanes(widest) > 32) {
    const hn::Half<decltype(widest)> half;
    if (pixel.room < 64) {
      return extend_groups<decltype(half), kGroup, kTerms, kClasses>(half, pass, pixel);
    }
  }
  return extend_groups<decltype(widest), kGroup, kTerms, kClasses>(widest, pass, pixel);
}

template <class Cell, int kTerms, bool kClasses>
ExtendPaths<Cell> choose_group(int paths) {
  if (paths % 4 == 0) return extend_paths<Cell, 4, kTerms, kClasses>;
  if (paths % 2 == 0) return extend_paths<Cell, 2, kTerms, kClasses>;
  return extend_paths<Cell, 1, kTerms, kClasses>;
}

template <class Cell, int kTerms>
ExtendPaths<Cell> choose_classes(const PassStep& pass) {
  return pass.match_classes == 1 ? choose_group<Cell, kTerms, false>(pass.paths)
                                 : choose_group<Cell, kTerms, true>(pass.paths);
}

template <class Cell>
ExtendPaths<Cell> choose(const PassStep& pass) {
  if (pass.match_classes > 2) return extend_paths_plain<Cell>;
  return pass.terms == 1 ? choose_classes<Cell, 1>(pass) : choose_classes<Cell, 2>(pass);
}

#endif

ExtendPaths<std::uint8_t> choose_8(const PassStep& pass) { return choose<std::uint8_t>(pass); }
ExtendPaths<std::uint16_t> choose_16(const PassStep& pass) { return choose<std::uint16_t>(pass); }

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::aggregation {

HWY_EXPORT(choose_8);
HWY_EXPORT(choose_16);

template <>
ExtendPaths<std::uint8_t> choose_extend_paths(const PassStep& pass) {
  return HWY_DYNAMIC_DISPATCH(choose_8)(pass);
}
template <>
ExtendPaths<std::uint16_t> choose_extend_paths(const PassStep& pass) {
  return HWY_DYNAMIC_DISPATCH(choose_16)(pass);
}

}  // namespace xgm::aggregation
#endif
