// SPDX-License-Identifier: Apache-2.0
// d(x_L, x_R): the pixel of one view against the range of the other, whichever way is closer.
#include <algorithm>

#include "plugins/cost/birchfield_tomasi/dissimilarity.hpp"
#include "plugins/cost/birchfield_tomasi/intensity_range.hpp"
#include "plugins/cost/candidate_costs/truncated_mean.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/cost/birchfield_tomasi/dissimilarity_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plugins/cost/candidate_costs/truncated_mean-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::birchfield_tomasi::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

/// Distance of a grey level to the nearest level in [low, high].
float distance(float value, float low, float high) {
  return std::max({0.0F, value - high, low - value});
}

struct Dissimilarity {
  static constexpr int kNumbers = kIntensities;
  using Numbers = std::array<float, kNumbers>;
  static float of(const Numbers& a, const Numbers& b) {
    return std::min(distance(a[kValue], b[kLow], b[kHigh]), distance(b[kValue], a[kLow], a[kHigh]));
  }
};

void compare_row(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  cost::truncated_mean_plain<Dissimilarity>(rows, y, truncation, costs);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

struct Dissimilarity {
  static constexpr int kNumbers = kIntensities;

  template <class D, class V>
  static HWY_INLINE V of(D d, const V* a, const V* b) {
    return hn::Min(distance(d, a[kValue], b[kLow], b[kHigh]),
                   distance(d, b[kValue], a[kLow], a[kHigh]));
  }

 private:
  template <class D, class V>
  static HWY_INLINE V distance(D d, V value, V low, V high) {
    return larger(larger(hn::Zero(d), hn::Sub(value, high)), hn::Sub(low, value));
  }
  /// std::max: of NaN and a number, the first one.
  template <class V>
  static HWY_INLINE V larger(V a, V b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
  }
};

void compare_row(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  cost::HWY_NAMESPACE::truncated_mean<Dissimilarity>(rows, y, truncation, costs);
}

#endif

}  // namespace xgm::birchfield_tomasi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::birchfield_tomasi {

HWY_EXPORT(compare_row);

void compare(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  XGM_SIMD_DISPATCH(compare_row)(rows, y, truncation, costs);
}

}  // namespace xgm::birchfield_tomasi
#endif
