// SPDX-License-Identifier: Apache-2.0
// For kernels that Highway compiles for several targets: calls them with the target of the run.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "xgm/base/export.hpp"

namespace xgm {

/// The targets that the calling thread's run may use, in the order of Highway's dispatch tables.
XGM_API std::uint64_t simd_dispatch_mask();

/// The best entry of a dispatch table for this run. `compiled`: the entries that there are.
template <class Function, std::size_t kEntries>
Function* simd_choose(Function* const (&table)[kEntries], std::uint64_t compiled) {
  if constexpr (kEntries == 1) {
    return table[0];  // compiled for one target only
  } else {
    return table[std::countr_zero(simd_dispatch_mask() & compiled)];
  }
}

}  // namespace xgm

/// The function to call after HWY_EXPORT(function). HWY_DYNAMIC_DISPATCH would obey one choice for
/// the whole process instead of that of the run.
#define XGM_SIMD_DISPATCH(function)                \
  (*xgm::simd_choose(HWY_DISPATCH_TABLE(function), \
                     static_cast<std::uint64_t>(HWY_CHOSEN_TARGET_MASK_TARGETS)))
