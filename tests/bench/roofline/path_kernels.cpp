// SPDX-License-Identifier: Apache-2.0
// Path steps by hand, compiled for every SIMD target.
#include "bench/roofline/path_kernels.hpp"

#include "bench/roofline/plain_paths.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/roofline/path_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::bench::path_steps::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

PathLoops loops() { return {}; }

#else

namespace hn = hwy::HWY_NAMESPACE;

template <class Cell>
using Tag = hn::CappedTag<Cell, kDisparities>;
template <class Cell>
using Cells = hn::Vec<Tag<Cell> >;

/// What the step of one path keeps in registers.
template <class Cell>
struct Predecessor {
  const Cell* cells;
  Cells<Cell> minimum, far;

  HWY_INLINE Predecessor(PathSlice<Cell>& slice, Cell p2)
      : cells(slice.at(0)),
        minimum(hn::Set(Tag<Cell>(), slice.minimum)),
        far(hn::SaturatedAdd(minimum, hn::Set(Tag<Cell>(), p2))) {}

  HWY_INLINE Cells<Cell> term(int d, Cells<Cell> p1) const {
    const Tag<Cell> tag;
    const auto beside = hn::Min(hn::LoadU(tag, cells + d - 1), hn::LoadU(tag, cells + d + 1));
    const auto near = hn::Min(hn::Load(tag, cells + d), hn::SaturatedAdd(beside, p1));
    return hn::Sub(hn::Min(near, far), minimum);
  }
};

/// The mean, halves to even.
template <class Cell>
HWY_INLINE Cells<Cell> mean(Cells<Cell> a, Cells<Cell> b) {
  const auto up = hn::AverageRound(a, b);
  const auto odd = hn::And(hn::And(up, hn::Xor(a, b)), hn::Set(Tag<Cell>(), Cell{1}));
  return hn::Sub(up, odd);
}

HWY_INLINE Cells<std::uint8_t> load_costs(const std::uint8_t* costs, std::uint8_t) {
  return hn::Load(Tag<std::uint8_t>(), costs);
}
HWY_INLINE Cells<std::uint16_t> load_costs(const std::uint8_t* costs, std::uint16_t) {
  const Tag<std::uint16_t> tag;
  return hn::PromoteTo(tag, hn::Load(hn::Rebind<std::uint8_t, decltype(tag)>(), costs));
}

/// sums += the terms of one path, or of two that fit one cell together.
HWY_INLINE void add_to(std::uint16_t* sums, Cells<std::uint16_t> term) {
  const Tag<std::uint16_t> tag;
  hn::Store(hn::Add(hn::Load(tag, sums), term), tag, sums);
}
HWY_INLINE void add_to(std::uint16_t* sums, Cells<std::uint8_t> term) {
  const Tag<std::uint8_t> narrow;
  const hn::Half<decltype(narrow)> half;
  const hn::RepartitionToWide<decltype(narrow)> wide;
  const auto low = hn::PromoteTo(wide, hn::LowerHalf(half, term));
  const auto high = hn::PromoteTo(wide, hn::UpperHalf(half, term));
  std::uint16_t* next = sums + hn::Lanes(wide);
  hn::Store(hn::Add(hn::Load(wide, sums), low), wide, sums);
  hn::Store(hn::Add(hn::Load(wide, next), high), wide, next);
}

HWY_INLINE std::uint16_t min_of(Cells<std::uint16_t> cells) {
  return hn::GetLane(hn::MinOfLanes(Tag<std::uint16_t>(), cells));
}
HWY_INLINE std::uint8_t min_of(Cells<std::uint8_t> cells) {
  const hn::RepartitionToWide<Tag<std::uint8_t> > wide;
  const auto pairs = hn::BitCast(wide, cells);
  const auto low = hn::And(pairs, hn::Set(wide, std::uint16_t{255}));
  const auto minimum = hn::MinOfLanes(wide, hn::Min(low, hn::ShiftRight<8>(pairs)));
  return static_cast<std::uint8_t>(hn::GetLane(minimum));
}

template <class Cell, bool kTwoTerms>
struct Path {
  Predecessor<Cell> left, above;
  Cell* own;
  Cells<Cell> minimum = hn::Set(Tag<Cell>(), static_cast<Cell>(-1));

  HWY_INLINE Path(PathBuffers<Cell>& buffers, int row, int path, int pixel)
      : left(slice(buffers, row, path, (pixel + kPixels - 1) % kPixels), buffers.p2),
        above(slice(buffers, 1 - row, path, pixel), buffers.p2),
        own(slice(buffers, row, path, pixel).at(0)) {}

  static HWY_INLINE PathSlice<Cell>& slice(PathBuffers<Cell>& buffers, int row, int path,
                                           int pixel) {
    return buffers.paths[static_cast<std::size_t>(row)][static_cast<std::size_t>(path)]
                        [static_cast<std::size_t>(pixel)];
  }

  /// Returns the term.
  HWY_INLINE Cells<Cell> extend(int d, Cells<Cell> cost, Cells<Cell> p1) {
    auto term = left.term(d, p1);
    if constexpr (kTwoTerms) term = mean<Cell>(term, above.term(d, p1));
    const auto extended = hn::SaturatedAdd(cost, term);
    hn::Store(extended, Tag<Cell>(), own + d);
    minimum = hn::Min(minimum, extended);
    return term;
  }
};

template <class Cell, bool kTwoTerms>
HWY_INLINE void step_one(PathBuffers<Cell>& buffers, int row, int pixel) {
  const auto p1 = hn::Set(Tag<Cell>(), buffers.p1);
  const std::uint8_t* costs = buffers.costs[static_cast<std::size_t>(pixel)].data();
  std::uint16_t* sums = buffers.sums[static_cast<std::size_t>(pixel)].data();
  Path<Cell, kTwoTerms> path(buffers, row, 0, pixel);
  for (int d = 0; d < kDisparities; d += static_cast<int>(hn::Lanes(Tag<Cell>()))) {
    add_to(sums + d, path.extend(d, load_costs(costs + d, Cell{}), p1));
  }
  Path<Cell, kTwoTerms>::slice(buffers, row, 0, pixel).minimum = min_of(path.minimum);
}

template <class Cell, bool kTwoTerms>
HWY_INLINE void step_four(PathBuffers<Cell>& buffers, int row, int pixel) {
  using OnePath = Path<Cell, kTwoTerms>;
  const auto p1 = hn::Set(Tag<Cell>(), buffers.p1);
  const std::uint8_t* costs = buffers.costs[static_cast<std::size_t>(pixel)].data();
  std::uint16_t* sums = buffers.sums[static_cast<std::size_t>(pixel)].data();
  OnePath a(buffers, row, 0, pixel), b(buffers, row, 1, pixel);
  OnePath c(buffers, row, 2, pixel), e(buffers, row, 3, pixel);
  for (int d = 0; d < kDisparities; d += static_cast<int>(hn::Lanes(Tag<Cell>()))) {
    const auto cost = load_costs(costs + d, Cell{});
    // A term is at most P2 = 96: two of them fit 8 bit.
    const auto first = hn::Add(a.extend(d, cost, p1), b.extend(d, cost, p1));
    const auto second = hn::Add(c.extend(d, cost, p1), e.extend(d, cost, p1));
    add_to(sums + d, first);
    add_to(sums + d, second);
  }
  OnePath::slice(buffers, row, 0, pixel).minimum = min_of(a.minimum);
  OnePath::slice(buffers, row, 1, pixel).minimum = min_of(b.minimum);
  OnePath::slice(buffers, row, 2, pixel).minimum = min_of(c.minimum);
  OnePath::slice(buffers, row, 3, pixel).minimum = min_of(e.minimum);
}

template <class Cell, bool kTwoTerms>
void loop_one(PathBuffers<Cell>& buffers) {
  for (int round = 0; round < kRounds; ++round) {
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      step_one<Cell, kTwoTerms>(buffers, round % 2, pixel);
    }
  }
}

template <class Cell, bool kTwoTerms>
void loop_four(PathBuffers<Cell>& buffers) {
  for (int round = 0; round < kRounds; ++round) {
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      step_four<Cell, kTwoTerms>(buffers, round % 2, pixel);
    }
  }
}

PathLoops loops() {
  using Narrow = std::uint8_t;
  using Wide = std::uint16_t;
  return {hwy::TargetName(HWY_TARGET), loop_one<Narrow, false>, loop_four<Narrow, false>,
          loop_one<Narrow, true>,      loop_four<Narrow, true>, loop_one<Wide, false>,
          loop_four<Wide, false>,      loop_one<Wide, true>,    loop_four<Wide, true>};
}

#endif

}  // namespace xgm::bench::path_steps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "bench/roofline/each_target.hpp"
#include "xgm/base/random.hpp"
#include "xgm/base/simd_dispatch.hpp"

namespace xgm::bench {

namespace path_steps {
HWY_EXPORT(loops);
PathLoops chosen() { return XGM_SIMD_DISPATCH(loops)(); }
}  // namespace path_steps

template <class Cell>
PathBuffers<Cell>::PathBuffers(std::uint64_t seed) {
  Random random(seed);
  for (auto& pixel : costs) {
    for (auto& cost : pixel) cost = static_cast<std::uint8_t>(random.integer(0, 24));
  }
  for (auto& pixel : sums) pixel.fill(0);
  for (auto& row : paths) {
    for (auto& path : row) {
      for (auto& slice : path) {
        slice.cells.fill(static_cast<Cell>(-1));
        std::copy(costs[0].begin(), costs[0].end(), slice.at(0));
        slice.minimum = *std::min_element(costs[0].begin(), costs[0].end());
      }
    }
  }
}

template struct PathBuffers<std::uint8_t>;
template struct PathBuffers<std::uint16_t>;

std::vector<PathLoops> path_loops() {
  using Narrow = std::uint8_t;
  using Wide = std::uint16_t;
  std::vector<PathLoops> all{{"plain", plain_loop<Narrow, false, 1>, plain_loop<Narrow, false, 4>,
                              plain_loop<Narrow, true, 1>, plain_loop<Narrow, true, 4>,
                              plain_loop<Wide, false, 1>, plain_loop<Wide, false, 4>,
                              plain_loop<Wide, true, 1>, plain_loop<Wide, true, 4>}};
  for_each_target([&] { all.push_back(path_steps::chosen()); });
  std::erase_if(all, [](const PathLoops& one) { return one.target.empty(); });
  return all;
}

}  // namespace xgm::bench
#endif
