// SPDX-License-Identifier: Apache-2.0
// Truncated mean differences, a vector of cells at a time. To be included by kernels, after
// hwy/highway.h; compiled once per target.
#include "plugins/cost/candidate_costs/truncated_mean.hpp"

#if defined(XGM_TRUNCATED_MEAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef XGM_TRUNCATED_MEAN_INL
#undef XGM_TRUNCATED_MEAN_INL
#else
#define XGM_TRUNCATED_MEAN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace xgm::cost::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Levels = hn::CappedTag<float, VolumeShape::kGranule>;
using LevelsVec = hn::Vec<Levels>;

/// Sum over the channels of the differences between base pixel x and the candidates from `first`.
template <class Difference, int kChannels>
HWY_INLINE LevelsVec sum_of_differences(const RowPair<float>& rows, int x, int first) {
  constexpr Levels d;
  LevelsVec sum = hn::Zero(d);
  for (int c = 0; c < kChannels; ++c) {
    LevelsVec own[Difference::kNumbers], other[Difference::kNumbers];
    for (int k = 0; k < Difference::kNumbers; ++k) {
      const int plane = c * Difference::kNumbers + k;
      own[k] = hn::Set(d, rows.base.plane(plane)[x]);
      other[k] = hn::LoadU(d, rows.match.plane(plane) + first);
    }
    sum = hn::Add(sum, Difference::of(d, own, other));
  }
  return kChannels == 1 ? sum : hn::Div(sum, hn::Set(d, float{kChannels}));
}

template <class Difference, int kChannels>
void truncated_mean(const RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  constexpr Levels d;
  const hn::RebindToSigned<Levels> d32;
  const hn::Rebind<std::uint8_t, Levels> d8;
  const LevelsVec most = hn::Set(d, truncation);
  const VolumeShape& shape = costs.shape();
  for (int x = 0; x < shape.width(); ++x) {
    const int first = RowPair<float>::first(shape, y, x);
    const int room = shape.room(y, x);
    std::uint8_t* const cells = costs.at(y, x);
    for (int i = 0; i < room; i += static_cast<int>(hn::MaxLanes(d))) {
      const LevelsVec mean = sum_of_differences<Difference, kChannels>(rows, x, first + i);
      const LevelsVec cost = hn::IfThenElse(hn::Lt(mean, most), mean, most);  // NaN: the most
      const auto rounded = hn::ConvertTo(d32, hn::Add(cost, hn::Set(d, 0.5F)));
      const auto absent = hn::LoadU(d8, rows.match.absent() + first + i);
      hn::StoreU(hn::Or(hn::DemoteTo(d8, rounded), absent), d8, cells + i);
    }
  }
}

/// truncated_mean_plain() with vectors: Difference::of(d, a, b) gets arrays of them.
template <class Difference>
void truncated_mean(const RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  if (rows.channels == 1) return truncated_mean<Difference, 1>(rows, y, truncation, costs);
  return truncated_mean<Difference, 3>(rows, y, truncation, costs);
}

}  // namespace xgm::cost::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
