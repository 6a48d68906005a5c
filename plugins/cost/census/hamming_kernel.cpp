// SPDX-License-Identifier: Apache-2.0
// Hamming distances, as many cells at a time as a vector has bytes.
#include "plugins/cost/census/hamming.hpp"
#include "xgm/base/simd_dispatch.hpp"

#include <algorithm>

#define HWY_WANT_AVX3_DL  // counts the bits of a vector in one instruction
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/cost/census/hamming_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::census::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

void hamming_row(const RowPair& rows, int y, CostVolume& costs) { hamming_plain(rows, y, costs); }

#else

namespace hn = hwy::HWY_NAMESPACE;

/// (bits + 1) / 3: a third, rounded. There is no product of bytes, so even and odd ones in turn.
template <class D>
HWY_INLINE hn::Vec<D> third(D d, hn::Vec<D> bits) {
  const hn::Repartition<std::uint16_t, D> d16;
  const auto factor = hn::Set(d16, std::uint16_t{21846});  // 2^16 / 3, exact enough for 8 bits
  const auto sum = hn::BitCast(d16, hn::Add(bits, hn::Set(d, std::uint8_t{1})));
  const auto even = hn::MulHigh(hn::And(sum, hn::Set(d16, std::uint16_t{0xFF})), factor);
  const auto odd = hn::MulHigh(hn::ShiftRight<8>(sum), factor);
  return hn::BitCast(d, hn::Or(even, hn::ShiftLeft<8>(odd)));
}

/// All planes of one pixel: a byte of each, `stride` bytes apart.
struct Planes {
  const std::uint8_t* bytes;
  std::size_t stride;
};

// A number of planes that is not known at compile time, and the largest.
constexpr int kAny = 0, kMaxPlanes = 32;

/// The base pixel's candidates: planes of the first one, and where it says that there is none.
struct Candidates {
  Planes planes;
  const std::uint8_t* absent;
};

/// Writes `room` cells, at least as many as a vector has lanes; the last two vectors may overlap.
template <int kPlanes, int kChannels, class D>
HWY_INLINE void write_slice(D d, int plane_count, const Planes& pixel, const Candidates& candidates,
                            int room, std::uint8_t* cells) {
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
  const int planes = kPlanes == kAny ? plane_count : kPlanes;
  hn::Vec<D> own[kPlanes == kAny ? kMaxPlanes : kPlanes];
  const std::uint8_t* byte = pixel.bytes;
  for (int k = 0; k < planes; ++k, byte += pixel.stride) own[k] = hn::Set(d, *byte);
  for (int end = kLanes;; end = std::min(end + kLanes, room)) {
    const int i = end - kLanes;
    auto bits = hn::Zero(d);
    const std::uint8_t* other = candidates.planes.bytes + i;
    for (int k = 0; k < planes; ++k, other += candidates.planes.stride)
      bits = hn::Add(bits, hn::PopulationCount(hn::Xor(own[k], hn::LoadU(d, other))));
    if (kChannels == 3) bits = third(d, bits);
    hn::StoreU(hn::Or(bits, hn::LoadU(d, candidates.absent + i)), d, cells + i);
    if (end == room) return;
  }
}

template <int kPlanes, int kChannels>
void write_row(const RowPair& rows, int y, CostVolume& costs) {
  const hn::CappedTag<std::uint8_t, 64> widest;
  const hn::CappedTag<std::uint8_t, 32> middle;
  const hn::CappedTag<std::uint8_t, 16> granule;
  const VolumeShape& shape = costs.shape();
  const int planes = rows.base.plane_count();
  const Planes base{rows.base.plane(0), rows.base.stride()};
  const Planes match{rows.match.plane(0), rows.match.stride()};
  const std::uint8_t* const absent = rows.match.absent();
  for (int x = 0; x < shape.width(); ++x) {
    const int room = shape.room(y, x);
    if (room == 0) continue;
    const int first = RowPair::first(shape, y, x);
    const auto write = [&](auto d) HWY_ATTR {
      write_slice<kPlanes, kChannels>(d, planes, {base.bytes + x, base.stride},
                                      {{match.bytes + first, match.stride}, absent + first}, room,
                                      costs.at(y, x));
    };
    if (room >= static_cast<int>(hn::MaxLanes(widest))) {
      write(widest);
    } else if (room >= static_cast<int>(hn::MaxLanes(middle))) {
      write(middle);
    } else {
      write(granule);
    }
  }
}

void hamming_row(const RowPair& rows, int y, CostVolume& costs) {
  const int planes = rows.base.plane_count();
  if (rows.channels == 3) {
    if (planes == 9) return write_row<9, 3>(rows, y, costs);  // 5x5
    return write_row<kAny, 3>(rows, y, costs);
  }
  switch (planes) {
    case 1:
      return write_row<1, 1>(rows, y, costs);  // 3x3
    case 3:
      return write_row<3, 1>(rows, y, costs);  // 5x5
    case 6:
      return write_row<6, 1>(rows, y, costs);  // 7x7
    default:
      return write_row<kAny, 1>(rows, y, costs);
  }
}

#endif

}  // namespace xgm::census::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::census {

HWY_EXPORT(hamming_row);

void hamming(const RowPair& rows, int y, CostVolume& costs) {
  XGM_SIMD_DISPATCH(hamming_row)(rows, y, costs);
}

}  // namespace xgm::census
#endif
