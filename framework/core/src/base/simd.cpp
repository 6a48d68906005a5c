// SPDX-License-Identifier: Apache-2.0
// The one place that tells Highway which target to choose.
#include "xgm/base/simd.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "xgm/base/error.hpp"

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

std::int64_t& chosen() {
  static std::int64_t targets = usable();
  return targets;
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

void use_simd(std::string_view name) {
  std::int64_t wanted = name.empty() ? usable() : 0;
  std::string known;
  for (const Target& target : kTargets) {
    if ((usable() & target.bit) == 0) continue;
    known += (known.empty() ? "" : ", ") + std::string(target.name);
    // Where a kernel has nothing for this target, it takes the next one down.
    if (name == target.name) wanted = usable() & ~(target.bit - 1);
  }
  if (wanted == 0) {
    throw Error("this processor has no SIMD target '" + std::string(name) + "'; it has " + known);
  }
  chosen() = wanted;
  hwy::SetSupportedTargetsForTest(wanted);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace xgm
