// SPDX-License-Identifier: Apache-2.0
// Which of the targets that kernels are compiled for is used.
#include "xgm/base/simd.hpp"

#define HWY_WANT_AVX3_DL  // some kernels do
#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "base/run_state.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/simd_dispatch.hpp"

namespace xgm {
namespace {

struct Target {
  const char* name;
  std::int64_t bit;
};

// A lower bit is a better target.
constexpr std::array<Target, 7> kTargets{{{"avx512_dl", HWY_AVX3_DL},
                                          {"avx512", HWY_AVX3},
                                          {"avx2", HWY_AVX2},
                                          {"sse4", HWY_SSE4},
                                          {"neon", HWY_NEON},
                                          {"scalar", HWY_EMU128},
                                          {"scalar", HWY_SCALAR}}};

/// What kernels are compiled for and this processor has.
std::int64_t usable() {
  static const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
  return supported & HWY_TARGETS;
}

/// What the calling thread's run may use.
std::int64_t chosen() {
  const std::int64_t simd = run_state().simd;
  return simd != 0 ? simd : usable();
}

/// `name` and what is below it: where a kernel has nothing for a target, it takes the next one.
std::int64_t from_here_down(std::string_view name) {
  std::string known;
  for (const Target& target : kTargets) {
    if ((usable() & target.bit) == 0) continue;
    if (name == target.name) return usable() & ~(target.bit - 1);
    known += (known.empty() ? "" : ", ") + std::string(target.name);
  }
  throw UsageError("this processor has no SIMD target '" + std::string(name) + "'; it has " +
                   known);
}

}  // namespace

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const Target& target : kTargets) {
    if ((usable() & target.bit) != 0) names.emplace_back(target.name);
  }
  return names;
}

std::string simd_target() {
  for (const Target& target : kTargets) {
    if ((chosen() & target.bit) != 0) return target.name;
  }
  return "scalar";
}

SimdChoice::SimdChoice(std::string_view target) {
  if (target.empty()) return;
  RunState state = run_state();
  state.simd = from_here_down(target);
  change_ = std::make_unique<RunChange>(std::move(state));
}

SimdChoice::~SimdChoice() = default;

std::uint64_t simd_dispatch_mask() {
  return static_cast<std::uint64_t>(HWY_CHOSEN_TARGET_SHIFT(chosen()) |
                                    HWY_CHOSEN_TARGET_MASK_SCALAR);
}

}  // namespace xgm
