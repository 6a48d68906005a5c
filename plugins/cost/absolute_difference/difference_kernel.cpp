// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "plugins/cost/absolute_difference/difference.hpp"
#include "plugins/cost/candidate_costs/truncated_mean.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/cost/absolute_difference/difference_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plugins/cost/candidate_costs/truncated_mean-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::absolute_difference::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

struct Difference {
  static constexpr int kNumbers = 1;
  using Numbers = std::array<float, kNumbers>;
  static float of(const Numbers& a, const Numbers& b) { return std::abs(a[0] - b[0]); }
};

void compare_row(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  cost::truncated_mean_plain<Difference>(rows, y, truncation, costs);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

struct Difference {
  static constexpr int kNumbers = 1;
  template <class D, class V>
  static HWY_INLINE V of(D, const V* a, const V* b) {
    return hn::Abs(hn::Sub(a[0], b[0]));
  }
};

void compare_row(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  cost::HWY_NAMESPACE::truncated_mean<Difference>(rows, y, truncation, costs);
}

#endif

}  // namespace xgm::absolute_difference::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::absolute_difference {

HWY_EXPORT(compare_row);

void compare(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  XGM_SIMD_DISPATCH(compare_row)(rows, y, truncation, costs);
}

}  // namespace xgm::absolute_difference
#endif
