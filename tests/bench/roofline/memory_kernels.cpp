// SPDX-License-Identifier: Apache-2.0
// Ways through memory, compiled for every SIMD target.
#include "bench/roofline/memory_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/roofline/memory_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "xgm/base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::bench::memory_passes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<std::uint16_t, 32>;

std::uint64_t read(const std::uint16_t* from, std::size_t count) {
  const Tag tag;
  const std::size_t step = hn::Lanes(tag);
  auto first = hn::Zero(tag), second = hn::Zero(tag);
  for (std::size_t i = 0; i < count; i += 2 * step) {
    first = hn::Add(first, hn::Load(tag, from + i));
    second = hn::Add(second, hn::Load(tag, from + i + step));
  }
  return hn::GetLane(hn::Add(first, second));
}

void write(std::uint16_t* to, std::size_t count) {
  const Tag tag;
  const auto value = hn::Set(tag, std::uint16_t{7});
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) hn::Store(value, tag, to + i);
}

void write_streaming(std::uint16_t* to, std::size_t count) {
  const Tag tag;
  const auto value = hn::Set(tag, std::uint16_t{7});
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) hn::Stream(value, tag, to + i);
  hwy::FlushStream();
}

void copy(const std::uint16_t* from, std::uint16_t* to, std::size_t count) {
  const Tag tag;
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
    hn::Store(hn::Load(tag, from + i), tag, to + i);
  }
}

void add(const std::uint16_t* from, std::uint16_t* to, std::size_t count) {
  const Tag tag;
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
    hn::Store(hn::Add(hn::Load(tag, to + i), hn::Load(tag, from + i)), tag, to + i);
  }
}

void change(std::uint16_t* to, std::size_t count) {
  const Tag tag;
  const auto one = hn::Set(tag, std::uint16_t{1});
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
    hn::Store(hn::Add(hn::Load(tag, to + i), one), tag, to + i);
  }
}

MemoryLoops loops() {
  return {hwy::TargetName(HWY_TARGET), read, write, write_streaming, copy, add, change};
}

}  // namespace xgm::bench::memory_passes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::bench {

namespace memory_passes {
HWY_EXPORT(loops);
MemoryLoops chosen() { return XGM_SIMD_DISPATCH(loops)(); }
}  // namespace memory_passes

MemoryLoops memory_loops() { return memory_passes::chosen(); }

}  // namespace xgm::bench
#endif
