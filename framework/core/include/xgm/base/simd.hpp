// SPDX-License-Identifier: Apache-2.0
// Which vector instructions the kernels use. They give the same results with all of them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

struct RunChange;

/// The instruction sets that kernels can use on this processor, best first. x86: "avx512_dl" (Ice
/// Lake, Zen 4), "avx512" (Skylake-X), "avx2" (Haswell, Zen), "sse4"; ARM: "neon"; "scalar" is code
/// without vector instructions of its own, and the reference of all others.
XGM_API std::vector<std::string> simd_targets();

/// The one that kernels use when the calling thread calls them: the best, unless a SimdChoice says
/// another.
XGM_API std::string simd_target();

/// While one lives, kernels that the calling thread calls, and the threads of its loops, use
/// `target`, one of simd_targets(). If it is empty, nothing changes.
class XGM_API SimdChoice {
 public:
  /// Throws Error if this processor does not have it.
  explicit SimdChoice(std::string_view target);
  ~SimdChoice();
  SimdChoice(const SimdChoice&) = delete;
  SimdChoice& operator=(const SimdChoice&) = delete;

 private:
  std::unique_ptr<RunChange> change_;
};

}  // namespace xgm
