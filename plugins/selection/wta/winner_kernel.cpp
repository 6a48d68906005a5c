// SPDX-License-Identifier: Apache-2.0
// Winners, a vector of cells at a time.
#include "plugins/selection/wta/winner.hpp"
#include "xgm/base/simd_dispatch.hpp"

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/selection/wta/winner_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::wta::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

void select_row(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map) {
  select_plain(sums, uniqueness, y, map);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

// A granule of a slice at most, so that no load leaves the slice.
using D = hn::CappedTag<std::uint16_t, VolumeShape::kGranule>;
using V = hn::Vec<D>;
constexpr D d;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
// Positions in a slice are counted in 16 bits.
constexpr int kLongest = 0x8000;
// In cells. What processors fetch by themselves ends with each page of 4 kB.
constexpr int kFetchedAhead = 4096;

/// The cells of one pixel.
class Slice {
 public:
  Slice(const std::uint16_t* cells, int count) : cells_(cells), count_(count) {}

  int count() const { return count_; }

  /// The cells from i on, kNoMatch behind the last one.
  HWY_INLINE V load(int i) const {
    const V cells = hn::LoadU(d, cells_ + i);
    if (i + kLanes <= count_) return cells;
    const auto there = hn::FirstN(d, static_cast<std::size_t>(count_ - i));
    return hn::IfThenElse(there, cells, hn::Set(d, kNoMatch));
  }

  HWY_INLINE std::uint16_t lowest() const {
    V even = hn::Set(d, kNoMatch), odd = even;
    int i = 0;
    for (; i + 2 * kLanes <= count_; i += 2 * kLanes) {
      hwy::Prefetch(cells_ + i + kFetchedAhead);
      even = hn::Min(even, hn::LoadU(d, cells_ + i));
      odd = hn::Min(odd, hn::LoadU(d, cells_ + i + kLanes));
    }
    for (; i < count_; i += kLanes) even = hn::Min(even, load(i));
    return lowest(hn::Min(even, odd));
  }

  /// The lowest lane. Halved first: for eight of them there is an instruction.
  static HWY_INLINE std::uint16_t lowest(V v) {
#if HWY_TARGET <= HWY_AVX2
    const hn::Half<D> half;
    return hn::GetLane(
        hn::MinOfLanes(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v))));
#else
    return hn::GetLane(hn::MinOfLanes(d, v));
#endif
  }

  /// The first cell of this value; there is one.
  HWY_INLINE int find(std::uint16_t value) const {
    const V wanted = hn::Set(d, value);
    for (int i = 0;; i += kLanes) {
      const std::intptr_t lane = hn::FindFirstTrue(d, hn::Eq(hn::LoadU(d, cells_ + i), wanted));
      if (lane >= 0) return i + static_cast<int>(lane);
    }
  }

 private:
  const std::uint16_t* cells_;
  int count_;
};

/// All about the cells but the best one and those beside it.
HWY_INLINE Ballot count_votes(const Slice& slice, int best, std::uint16_t low) {
  const hn::Repartition<std::uint32_t, D> d32;
  const V none = hn::Set(d, kNoMatch);
  // Less than 3 for the best cell and those beside it, which are no rivals.
  V position = hn::Iota(d, static_cast<std::uint16_t>(1 - best));
  V rival = none;
  auto total = hn::Zero(d32);
  Ballot ballot{low};
  for (int i = 0; i < slice.count(); i += kLanes) {
    const V cells = slice.load(i);
    const auto no_match = hn::Eq(cells, none);
    const auto sums = hn::BitCast(d32, hn::IfThenZeroElse(no_match, cells));
    total = hn::Add(total, hn::And(sums, hn::Set(d32, 0xFFFFU)));
    total = hn::Add(total, hn::ShiftRight<16>(sums));
    ballot.matchable += kLanes - static_cast<int>(hn::CountTrue(d, no_match));
    const auto near = hn::Eq(hn::Min(position, hn::Set(d, std::uint16_t{2})), position);
    rival = hn::Min(rival, hn::IfThenElse(near, none, cells));
    position = hn::Add(position, hn::Set(d, std::uint16_t{kLanes}));
  }
  ballot.rival = Slice::lowest(rival);
  ballot.total = hn::GetLane(hn::SumOfLanes(d32, total));
  return ballot;
}

void select_row(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map) {
  const VolumeShape& shape = sums.shape();
  for (int x = 0; x < shape.width(); ++x) {
    const Slice slice(sums.at(y, x), shape.count(y, x));
    if (slice.count() > kLongest) {
      select_plain(sums.at(y, x), slice.count(), shape.begin(y, x), uniqueness, y, x, map);
      continue;
    }
    const std::uint16_t low = slice.lowest();
    if (low == kNoMatch) {
      map.invalidate(y, x, Status::out_of_range);
      continue;
    }
    const int best = slice.find(low);
    if (uniqueness > 0 && !clearly_wins(count_votes(slice, best, low), uniqueness)) {
      map.invalidate(y, x, Status::ambiguous);
    } else {
      map.set(y, x, static_cast<float>(shape.begin(y, x) + best));
    }
  }
}

#endif

}  // namespace xgm::wta::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::wta {

HWY_EXPORT(select_row);

void select(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map) {
  XGM_SIMD_DISPATCH(select_row)(sums, uniqueness, y, map);
}

}  // namespace xgm::wta
#endif
