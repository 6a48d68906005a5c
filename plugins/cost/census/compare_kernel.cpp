// SPDX-License-Identifier: Apache-2.0
// Comparisons of pixels with neighbours, a vector of pixels at a time.
#include "plugins/cost/census/compare.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/cost/census/compare_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::census::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

void compare_row(const Neighbours& neighbours, const float* centres, int count, bool mirrored,
                 std::uint8_t* bytes) {
  compare_plain(neighbours, centres, 0, count, mirrored, bytes);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

void compare_row(const Neighbours& neighbours, const float* centres, int count, bool mirrored,
                 std::uint8_t* bytes) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToSigned<decltype(d)> d32;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
  int x = 0;
  for (; x + kLanes <= count; x += kLanes) {
    const auto centre = hn::LoadU(d, centres + x);
    auto bits = hn::Zero(d32);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const auto darker = hn::RebindMask(d32, hn::Lt(hn::LoadU(d, neighbours[k] + x), centre));
      bits = hn::Or(bits, hn::IfThenElseZero(darker, hn::Set(d32, 1 << k)));
    }
    if (mirrored) {
      hn::StoreU(hn::DemoteTo(d8, hn::Reverse(d32, bits)), d8, bytes - x - (kLanes - 1));
    } else {
      hn::StoreU(hn::DemoteTo(d8, bits), d8, bytes + x);
    }
  }
  compare_plain(neighbours, centres, x, count, mirrored, bytes);
}

#endif

}  // namespace xgm::census::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::census {

HWY_EXPORT(compare_row);

void compare(const Neighbours& neighbours, const float* centres, int count, bool mirrored,
             std::uint8_t* bytes) {
  XGM_SIMD_DISPATCH(compare_row)(neighbours, centres, count, mirrored, bytes);
}

void compare_plain(const Neighbours& neighbours, const float* centres, int first, int count,
                   bool mirrored, std::uint8_t* bytes) {
  for (int x = first; x < count; ++x) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      bits |= (neighbours[k][x] < centres[x] ? 1U : 0U) << k;
    }
    bytes[mirrored ? -x : x] = static_cast<std::uint8_t>(bits);
  }
}

}  // namespace xgm::census
#endif
