// SPDX-License-Identifier: Apache-2.0
// Which vector instructions the kernels use. They give the same results with all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// The instruction sets that kernels can use on this processor, best first. x86: "avx512_dl" (Ice
/// Lake, Zen 4), "avx512" (Skylake-X), "avx2" (Haswell, Zen), "sse4"; ARM: "neon"; "scalar" is code
/// without vector instructions of its own, and the reference of all others.
XGM_API std::vector<std::string> simd_targets();

/// The one in use: the best, unless use_simd() has said another.
XGM_API std::string simd_target();

/// From here on kernels use this one of simd_targets(), or the best if it is empty. Not to be
/// called while kernels run. Throws Error if this processor does not have it.
XGM_API void use_simd(std::string_view target);

}  // namespace xgm
