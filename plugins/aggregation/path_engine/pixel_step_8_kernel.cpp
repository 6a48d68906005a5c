// SPDX-License-Identifier: Apache-2.0
// The inner step with path costs of 8 bits. A file for each width: two processors share the time
// that compiling them takes.
#include "plugins/aggregation/path_engine/advance.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/aggregation/path_engine/pixel_step_8_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plugins/aggregation/path_engine/pixel_step_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

Advance<std::uint8_t> choose_8(const PassStep& pass) { return choose<std::uint8_t>(pass); }

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::aggregation {

HWY_EXPORT(choose_8);

template <>
Advance<std::uint8_t> choose_advance(const PassStep& pass) {
  return XGM_SIMD_DISPATCH(choose_8)(pass);
}

}  // namespace xgm::aggregation
#endif
