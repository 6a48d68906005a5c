// SPDX-License-Identifier: Apache-2.0
// Operations on vectors of path costs, for the SIMD target that is being compiled.
// A slice is handled in blocks, one vector each. Targets that have masks for bytes handle the end
// of a slice as a partial block. The others halve the block size down to one granule; slices
// consist of whole granules, so no cell is left over.
#if defined(XGM_AGGREGATION_BLOCKS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef XGM_AGGREGATION_BLOCKS_INL_HPP
#undef XGM_AGGREGATION_BLOCKS_INL_HPP
#else
#define XGM_AGGREGATION_BLOCKS_INL_HPP
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/data/volume.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr bool kMasks = HWY_TARGET <= HWY_AVX3;

template <class D>
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));

/// A mask of the first `present` lanes; empty if `present` is negative.
template <class D>
HWY_INLINE hn::Mask<D> present_lanes(D d, int present) {
  return hn::FirstN(d, static_cast<std::size_t>(present < 0 ? 0 : present));
}

/// v repeated to the width of `full`, so that short blocks at the end of a slice can take part in a
/// minimum over full vectors.
template <class D, class Full>
HWY_INLINE hn::VFromD<Full> repeated(D d, Full full, hn::VFromD<D> v) {
  if constexpr (hn::MaxLanes(d) == hn::MaxLanes(full)) {
    return v;
  } else {
    const hn::Twice<D> twice;
    return repeated(twice, full, hn::Combine(twice, v, v));
  }
}

/// `cost` in all lanes.
template <class D>
HWY_INLINE hn::VFromD<D> filled(D d, const Repeated& cost) {
  return hn::BitCast(d, hn::Set(hn::Repartition<std::uint32_t, D>(), cost.bits()));
}

/// Matching costs C in units of path costs; kNoMatch becomes infinite.
template <class D>
HWY_INLINE hn::VFromD<D> in_units(D d, hn::Vec<hn::Rebind<std::uint8_t, D> > cost, int bits) {
  if constexpr (sizeof(hn::TFromD<D>) == 1) {
    for (int bit = 0; bit < bits; ++bit) cost = hn::SaturatedAdd(cost, cost);  // 255 stays
    return cost;
  } else {
    const auto c = hn::PromoteTo(d, cost);
    const auto none = hn::Eq(c, hn::Set(d, CostVolume::kNoMatch));
    return hn::IfThenElse(none, hn::Set(d, kInfinite<std::uint16_t>), hn::ShiftLeftSame(c, bits));
  }
}

/// in_units() of the first `count` matching costs in memory; other lanes are infinite. Without a
/// branch: slices that are shorter than a vector are as frequent as others.
template <class D>
HWY_INLINE hn::VFromD<D> load_part_of_cost(D d, const std::uint8_t* cost, int bits, int count) {
  const hn::Rebind<std::uint8_t, D> d8;
  const auto exists = present_lanes(d8, count);
  const auto cells = kMasks ? hn::MaskedLoad(exists, d8, cost) : hn::LoadU(d8, cost);
  return in_units(d, hn::IfThenElse(exists, cells, hn::Set(d8, CostVolume::kNoMatch)), bits);
}

/// in_units() of matching costs in memory; lanes from `count` on are infinite.
template <class D>
HWY_INLINE hn::VFromD<D> load_cost(D d, const std::uint8_t* cost, int bits, int count) {
  const hn::Rebind<std::uint8_t, D> d8;
  if (HWY_LIKELY(count >= kLanes<D>)) return in_units(d, hn::LoadU(d8, cost), bits);
  return load_part_of_cost(d, cost, bits, count);
}

/// The match classes of the disparities i, i + 1, ... of a block.
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

/// The first lanes of v, as many as D has lanes.
template <class D, class Full>
HWY_INLINE hn::VFromD<D> first_lanes(D d, Full full, hn::VFromD<Full> v) {
  if constexpr (hn::MaxLanes(d) == hn::MaxLanes(full)) {
    return v;
  } else {
    const hn::Half<Full> half;
    return first_lanes(d, half, hn::LowerHalf(half, v));
  }
}

/// The mean, halves rounded to even. AverageRound rounds halves up; where that gives an odd number,
/// 1 is subtracted.
template <class D>
HWY_INLINE hn::VFromD<D> mean(D d, hn::VFromD<D> a, hn::VFromD<D> b) {
  const auto up = hn::AverageRound(a, b);
  return hn::Sub(up, hn::And(hn::And(hn::Xor(a, b), up), hn::Set(d, 1)));
}

/// 16-bit sums for as many lanes as a vector of path costs has. `present` is the number of cells
/// from `sums` on that belong to the slice; other cells are not touched.
template <class D>
struct Sums {
  using Wide = hn::Repartition<std::uint16_t, D>;
  hn::VFromD<Wide> low, high;

  HWY_INLINE Sums() : low(hn::Zero(Wide())), high(hn::Zero(Wide())) {}

  HWY_INLINE void add(D d, hn::VFromD<D> message) {
    low = hn::Add(low, lower(d, message));
    if constexpr (kTwo) high = hn::Add(high, upper(d, message));
  }
  /// Adds to sums in memory. Addition saturates, so that kNoMatch stays kNoMatch.
  HWY_INLINE void add_to(std::uint16_t* sums, int present) const {
    const Wide d;
    if (!kMasks || HWY_LIKELY(present >= kLanes<D>)) {
      hn::StoreU(hn::SaturatedAdd(low, hn::LoadU(d, sums)), d, sums);
      if constexpr (kTwo) {
        sums += kLanes<Wide>;
        hn::StoreU(hn::SaturatedAdd(high, hn::LoadU(d, sums)), d, sums);
      }
    } else {
      add_part(low, sums, present);
      if constexpr (kTwo) add_part(high, sums + kLanes<Wide>, present - kLanes<Wide>);
    }
  }
  /// Writes the first values of sums: weight * cost + messages, or kNoMatch where `cost` is
  /// infinite. `past_caches` requires whole cache lines.
  HWY_INLINE void begin(D d, hn::VFromD<D> cost, std::uint16_t weight, bool past_caches,
                        std::uint16_t* sums, int present) const {
    begin_half(lower(d, cost), low, weight, past_caches, sums, present);
    if constexpr (kTwo)
      begin_half(upper(d, cost), high, weight, past_caches, sums + kLanes<Wide>,
                 present - kLanes<Wide>);
  }

 private:
  static constexpr bool kTwo = sizeof(hn::TFromD<D>) == 1;

  static HWY_INLINE hn::VFromD<Wide> lower(D, hn::VFromD<D> v) {
    if constexpr (kTwo) {
      return hn::PromoteTo(Wide(), hn::LowerHalf(hn::Half<D>(), v));
    } else {
      return v;
    }
  }
  static HWY_INLINE hn::VFromD<Wide> upper(D, hn::VFromD<D> v) {
    return hn::PromoteTo(Wide(), hn::UpperHalf(hn::Half<D>(), v));
  }
  static HWY_INLINE void add_part(hn::VFromD<Wide> message, std::uint16_t* sums, int present) {
    const Wide d;
    const auto part = present_lanes(d, present);
    hn::BlendedStore(hn::SaturatedAdd(message, hn::MaskedLoad(part, d, sums)), part, d, sums);
  }
  static HWY_INLINE void begin_half(hn::VFromD<Wide> cost, hn::VFromD<Wide> message,
                                    std::uint16_t weight, bool past_caches, std::uint16_t* sums,
                                    int present) {
    constexpr std::uint16_t kNone = kInfinite<hn::TFromD<D> >;
    const Wide d;
    const auto none = hn::Eq(cost, hn::Set(d, kNone));
    const auto sum = hn::Add(hn::Mul(cost, hn::Set(d, weight)), message);
    const auto begun = hn::IfThenElse(none, hn::Set(d, AggregatedVolume::kNoMatch), sum);
    if (kMasks && HWY_UNLIKELY(present < kLanes<Wide>)) {
      hn::BlendedStore(begun, present_lanes(d, present), d, sums);
    } else if (past_caches) {
      hn::Stream(begun, d, sums);
    } else {
      hn::StoreU(begun, d, sums);
    }
  }
};

/// Minima of the lower and the upper half, repeated down to 16 bytes.
template <class D>
HWY_INLINE auto folded(D d, hn::VFromD<D> v) {
  if constexpr (hn::MaxLanes(d) * sizeof(hn::TFromD<D>) > 16) {
    const hn::Half<D> half;
    return folded(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    return v;
  }
}

/// Pairwise minima of the lanes of a and of b, interleaved: a, b, a, b, ...
template <class D>
HWY_INLINE hn::VFromD<D> min_in_turn(D d, hn::VFromD<D> a, hn::VFromD<D> b) {
  return hn::Min(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b));
}

/// 16 bytes whose lane k is the minimum of vector k, for one, two or four vectors at once. The
/// vectors are interleaved, so that each further minimum serves all of them.
template <class D, class V, class... More>
HWY_INLINE auto min_lanes(D d, V first, More... more) {
  using Cell = hn::TFromD<D>;
  constexpr std::size_t kVectors = 1 + sizeof...(more), kBytes = kVectors * sizeof(Cell);
  const V v[] = {first, more...};
  auto all = v[0];
  if constexpr (kVectors > 1) all = min_in_turn(d, v[0], v[1]);
  if constexpr (kVectors > 2) {
    const hn::RepartitionToWide<D> pairs;
    const auto a = hn::BitCast(pairs, all);
    const auto b = hn::BitCast(pairs, min_in_turn(d, v[2], v[3]));
    all = hn::Min(hn::BitCast(d, hn::InterleaveLower(pairs, a, b)),
                  hn::BitCast(d, hn::InterleaveUpper(pairs, a, b)));
  }
  const hn::FixedTag<Cell, 16 / sizeof(Cell)> d16;
  auto minimum = folded(d, all);
  if constexpr (kBytes <= 8) minimum = hn::Min(minimum, hn::ShiftRightBytes<8>(d16, minimum));
  if constexpr (kBytes <= 4) minimum = hn::Min(minimum, hn::ShiftRightBytes<4>(d16, minimum));
  if constexpr (kBytes <= 2) minimum = hn::Min(minimum, hn::ShiftRightBytes<2>(d16, minimum));
  if constexpr (kBytes <= 1) minimum = hn::Min(minimum, hn::ShiftRightBytes<1>(d16, minimum));
  return minimum;
}

/// Stores lanes 0 to kCount - 1 of v, 16 bytes, as Repeated.
template <int kCount, class V>
HWY_INLINE void store_repeated(V v, Repeated* to) {
  using Cell = hn::TFromV<V>;
  const hn::FixedTag<Cell, 16 / sizeof(Cell)> d;
  const hn::Repartition<std::uint16_t, decltype(d)> d16;
  auto twice = hn::BitCast(d16, v);
  if constexpr (sizeof(Cell) == 1) twice = hn::BitCast(d16, hn::InterleaveLower(d, v, v));
  const auto bits = hn::InterleaveLower(d16, twice, twice);
  const hn::FixedTag<std::uint16_t, 2 * kCount> few;
  static_assert(sizeof(Repeated) == 2 * sizeof(std::uint16_t));
  hn::StoreU(first_lanes(few, d16, bits), few, reinterpret_cast<std::uint16_t*>(to));
}

#endif

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
