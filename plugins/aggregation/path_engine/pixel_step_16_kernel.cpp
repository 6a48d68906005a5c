// SPDX-License-Identifier: Apache-2.0
// The inner step with path costs of 16 bits. A file for each width: two processors share the time
// that compiling them takes.
#include "plugins/aggregation/path_engine/advance.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/aggregation/path_engine/pixel_step_16_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plugins/aggregation/path_engine/pixel_step_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

Advance<std::uint16_t> choose_16(const PassStep& pass) { return choose<std::uint16_t>(pass); }

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::aggregation {

HWY_EXPORT(choose_16);

template <>
Advance<std::uint16_t> choose_advance(const PassStep& pass) {
  return XGM_SIMD_DISPATCH(choose_16)(pass);
}

}  // namespace xgm::aggregation
#endif
