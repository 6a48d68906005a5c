// SPDX-License-Identifier: Apache-2.0
// Hamming distances, as many cells at a time as a vector has bytes.
#include "plugins/cost/census/hamming.hpp"

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

/// Cells of one base pixel. The number of planes is known at compile time, or kAny.
template <int kPlanes, int kChannels>
class Slice {
 public:
  static constexpr int kAny = 0;

  Slice(const RowPair& rows, const VolumeShape& shape, int y, int x, std::uint8_t* cells)
      : rows_(rows),
        x_(x),
        first_(RowPair::first(shape, y, x)),
        room_(shape.room(y, x)),
        cells_(cells) {}

  /// Writes cells from i on in blocks of D, as many as there is room for. Returns the next cell.
  template <class D>
  HWY_INLINE int write(D d, int i) const {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
    for (; i + kLanes <= room_; i += kLanes) hn::StoreU(costs(d, first_ + i), d, cells_ + i);
    return i;
  }

 private:
  template <class D>
  HWY_INLINE hn::Vec<D> costs(D d, int candidate) const {
    auto bits = hn::Zero(d);
    const int planes = kPlanes == kAny ? rows_.base.plane_count() : kPlanes;
    for (int k = 0; k < planes; ++k) {
      const auto own = hn::Set(d, rows_.base.plane(k)[x_]);
      const auto other = hn::LoadU(d, rows_.match.plane(k) + candidate);
      bits = hn::Add(bits, hn::PopulationCount(hn::Xor(own, other)));
    }
    if (kChannels == 3) bits = third(d, bits);
    return hn::Or(bits, hn::LoadU(d, rows_.match.absent() + candidate));
  }

  const RowPair& rows_;
  int x_, first_, room_;
  std::uint8_t* cells_;
};

template <int kPlanes, int kChannels>
void write_row(const RowPair& rows, int y, CostVolume& costs) {
  const VolumeShape& shape = costs.shape();
  for (int x = 0; x < shape.width(); ++x) {
    const Slice<kPlanes, kChannels> slice(rows, shape, y, x, costs.at(y, x));
    int i = slice.write(hn::CappedTag<std::uint8_t, 64>(), 0);
    i = slice.write(hn::CappedTag<std::uint8_t, 32>(), i);
    slice.write(hn::CappedTag<std::uint8_t, 16>(), i);
  }
}

void hamming_row(const RowPair& rows, int y, CostVolume& costs) {
  constexpr int kAny = 0;
  if (rows.channels == 3) return write_row<kAny, 3>(rows, y, costs);
  switch (rows.base.plane_count()) {
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
  HWY_DYNAMIC_DISPATCH(hamming_row)(rows, y, costs);
}

}  // namespace xgm::census
#endif
