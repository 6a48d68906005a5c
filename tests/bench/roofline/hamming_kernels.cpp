// SPDX-License-Identifier: Apache-2.0
// Census and Hamming distance by hand, compiled for every SIMD target.
#include "bench/roofline/hamming_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/roofline/hamming_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::bench::row_steps::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

RowLoops loops() { return {}; }

#else

namespace hn = hwy::HWY_NAMESPACE;

void census(RowBuffers& row) {
  const hn::CappedTag<float, 16> tag;
  const hn::RebindToUnsigned<decltype(tag)> bits;
  for (std::size_t x = 0; x < kRowWidth; x += hn::Lanes(tag)) {
    const auto centre = hn::Load(tag, row.levels[kWindowReach].data() + RowBuffers::kPad + x);
    auto string = hn::Zero(bits);
    std::uint32_t bit = 1;
    for (std::size_t y = 0; y < RowBuffers::kRows; ++y) {
      for (std::size_t i = 0; i < RowBuffers::kRows; ++i) {
        if (y == kWindowReach && i == kWindowReach) continue;
        const float* beside = row.levels[y].data() + RowBuffers::kPad + x + i - kWindowReach;
        const auto less = hn::RebindMask(bits, hn::Lt(hn::LoadU(tag, beside), centre));
        string = hn::Or(string, hn::IfThenElseZero(less, hn::Set(bits, bit)));
        bit <<= 1;
      }
    }
    hn::Store(string, bits, row.strings.data() + x);
  }
}

void hamming(RowBuffers& row) {
  const hn::CappedTag<std::uint32_t, 16> tag;
  const hn::RebindToSigned<decltype(tag)> counts;
  const hn::Rebind<std::uint8_t, decltype(tag)> bytes;
  for (std::size_t x = 0; x < kRowWidth; ++x) {
    const auto own = hn::Set(tag, row.strings[x]);
    const std::uint32_t* first = row.mirrored.data() + (kRowWidth - 1 - x);
    std::uint8_t* costs = row.costs.data() + x * kRowDisparities;
    for (std::size_t d = 0; d < kRowDisparities; d += hn::Lanes(tag)) {
      const auto count = hn::PopulationCount(hn::Xor(hn::LoadU(tag, first + d), own));
      hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(counts, count)), bytes, costs + d);
    }
  }
}

RowLoops loops() { return {hwy::TargetName(HWY_TARGET), census, hamming}; }

#endif

}  // namespace xgm::bench::row_steps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <bit>

#include "bench/roofline/each_target.hpp"
#include "xgm/base/random.hpp"
#include "xgm/base/simd_dispatch.hpp"

namespace xgm::bench {

namespace row_steps {
HWY_EXPORT(loops);
RowLoops chosen() { return XGM_SIMD_DISPATCH(loops)(); }
}  // namespace row_steps

namespace {

void plain_census(RowBuffers& row) {
  for (std::size_t x = 0; x < kRowWidth; ++x) {
    const float centre = row.levels[kWindowReach][RowBuffers::kPad + x];
    std::uint32_t string = 0, bit = 1;
    for (std::size_t y = 0; y < RowBuffers::kRows; ++y) {
      for (std::size_t i = 0; i < RowBuffers::kRows; ++i) {
        if (y == kWindowReach && i == kWindowReach) continue;
        if (row.levels[y][RowBuffers::kPad + x + i - kWindowReach] < centre) string |= bit;
        bit <<= 1;
      }
    }
    row.strings[x] = string;
  }
}

void plain_hamming(RowBuffers& row) {
  for (std::size_t x = 0; x < kRowWidth; ++x) {
    for (std::size_t d = 0; d < kRowDisparities; ++d) {
      const std::uint32_t other = row.mirrored[kRowWidth - 1 - x + d];
      row.costs[x * kRowDisparities + d] =
          static_cast<std::uint8_t>(std::popcount(row.strings[x] ^ other));
    }
  }
}

}  // namespace

RowBuffers::RowBuffers(std::uint64_t seed) : strings(), costs() {
  Random random(seed);
  for (auto& line : levels) {
    for (float& level : line) level = static_cast<float>(random.integer(0, 255));
  }
  for (std::uint32_t& string : mirrored) {
    string = static_cast<std::uint32_t>(random.integer(0, (1 << 24) - 1));
  }
}

std::vector<RowLoops> row_loops() {
  std::vector<RowLoops> all{{"plain", plain_census, plain_hamming}};
  for_each_target([&] { all.push_back(row_steps::chosen()); });
  std::erase_if(all, [](const RowLoops& one) { return one.target.empty(); });
  return all;
}

}  // namespace xgm::bench
#endif
