// SPDX-License-Identifier: Apache-2.0
// The inner step in vectors, for the SIMD target that is being compiled. Up to four paths advance
// together: their minima, the only thing that one block waits for another with, are reduced at
// once.
#if defined(XGM_AGGREGATION_PIXEL_STEP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef XGM_AGGREGATION_PIXEL_STEP_INL_HPP
#undef XGM_AGGREGATION_PIXEL_STEP_INL_HPP
#else
#define XGM_AGGREGATION_PIXEL_STEP_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstring>

#include "plugins/aggregation/path_engine/advance.hpp"
#include "plugins/aggregation/path_engine/blocks_inl.hpp"
#include "plugins/aggregation/path_engine/one_block_inl.hpp"
#include "plugins/aggregation/path_engine/paths_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace xgm::aggregation::HWY_NAMESPACE {

/// Extends with `Extend` at each pixel.
template <class Extend, class Cell>
void advance(PassWalk<Cell>& walk, Band<Cell>& band, int first, int last) {
  const int lag = walk.lag(), count = band.count;
  for (int from = first; from < last; from += LineLayout::kPixels) {
    const int pixels = last - from < LineLayout::kPixels ? last - from : LineLayout::kPixels;
    for (int i = 0; i < count; ++i) {
      const int own = from - i * lag;
      if (walk.lay_out(band.lines[i], own, own + pixels)) Extend::look_back(band.lines[i]);
    }
    for (int k = 0; k < pixels; ++k) {
      for (int i = 0; i < count; ++i) {
        if (band.lines[i].layout.room[k] > 0) Extend::extend(walk, band.lines[i], k);
      }
    }
  }
  // Before others hear of it.
  if (band.lines[0].begins_sums && walk.step().past_caches) hwy::FlushStream();
}

struct Plainly {
  template <class Cell>
  static void look_back(WalkedLine<Cell>&) {}
  template <class Cell>
  static void extend(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k) {
    extend_plain(walk, line, k);
  }
};

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

template <class Cell>
Advance<Cell> choose(const PassStep&) {
  return advance<Plainly, Cell>;
}

#else

/// kPaths of the pass's kAllPaths, from kFirst on: they advance together, in vectors of up to D's
/// lanes.
template <class D, int kFirst, int kPaths, int kAllPaths, int kTerms, bool kClasses>
class Group {
 public:
  using Cell = hn::TFromD<D>;

  HWY_INLINE Group(const PassWalk<Cell>& walk, const WalkedLine<Cell>& line, int k)
      : room_(line.layout.room[k]),
        count_(line.layout.count[k]),
        bits_(walk.step().bits),
        begins_sums_(kFirst == 0 && line.begins_sums),
        // What other paths are still added to had better stay.
        past_caches_(kPaths == kAllPaths && line.begins_sums && walk.step().past_caches),
        pairs_fit_(pairs_fit<Cell>(walk.step())),
        cost_weight_(static_cast<std::uint16_t>(walk.step().cost_weight)),
        cost_(walk.costs() + line.layout.offset[k]),
        next_cost_(walk.costs() + line.layout.offset[k + LineLayout::kAhead]),
        sums_(walk.sums() + line.layout.offset[k]),
        next_sums_(walk.sums() + line.layout.offset[k + LineLayout::kAhead]),
        classes_(nullptr) {
    if constexpr (kClasses)
      classes_ = walk.match_classes(line, line.layout.first + k, line.layout.begin[k]);
  }

  /// `found` are the terms of all paths if they are not as usual, else null.
  HWY_INLINE void run(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k,
                      const Term<Cell>* found) {
    const auto term = [&](int path, int t) HWY_ATTR {
      const int step = (kFirst + path) * kTerms + t;
      return found != nullptr ? found[step]
                              : usual_term<kAllPaths, kTerms, kClasses>(line, k, step);
    };
    const auto path = [&](int p) HWY_ATTR {
      return PathInRegisters<D, kTerms, kClasses>(term(p, 0), term(p, kTerms - 1),
                                                  line.costs[kFirst + p] + line.layout.own[k]);
    };
    Repeated* const minimum = minima_of<kAllPaths>(line, k) + kFirst;
    if constexpr (kPaths == 1) {
      run_paths(walk, minimum, path(0));
    } else if constexpr (kPaths == 2) {
      run_paths(walk, minimum, path(0), path(1));
    } else {
      run_paths(walk, minimum, path(0), path(1), path(2), path(3));
    }
  }

 private:
  template <class... Paths>
  HWY_INLINE void run_paths(const PassWalk<Cell>& walk, Repeated* all_min, Paths... paths) {
    extend(D(), 0, paths...);
    (std::memset(paths.costs() + room_, 0xFF, VolumeShape::kGranule * sizeof(Cell)), ...);
    Cell* const costs[kPaths] = {paths.costs()...};
    store_minima<kPaths>(walk.step(), min_lanes(D(), paths.minimum()...), costs, room_, all_min);
  }

  template <class Block, class... Paths>
  HWY_INLINE void extend(Block d, int i, Paths&... paths) {
    constexpr int lanes = kLanes<Block>;
    if constexpr (kMasks) {
      for (; i < room_; i += lanes) extend_block(d, i, paths...);
    } else {
      for (; i + lanes <= room_; i += lanes) extend_block(d, i, paths...);
      if constexpr (lanes > VolumeShape::kGranule) extend(hn::Half<Block>(), i, paths...);
    }
  }

  template <class Block, class... Paths>
  HWY_INLINE void extend_block(Block d, int i, Paths&... paths) {
    if constexpr (kFirst == 0) prefetch(d, i);
    const auto cost = load_cost(d, cost_ + i, bits_, count_ - i);
    const auto classes = load_classes<kClasses>(d, classes_, i);
    const hn::VFromD<Block> message[kPaths] = {paths.extend(d, cost, classes, i)...};
    Sums<Block> sums;
    for (int p = 0; p < kPaths; ++p) {
      if (kPaths > 1 && pairs_fit_) {
        sums.add(d, hn::Add(message[p], message[p + 1]));
        ++p;
      } else {
        sums.add(d, message[p]);
      }
    }
    if (begins_sums_) {
      sums.begin(d, cost, cost_weight_, past_caches_, sums_ + i, room_ - i);
    } else {
      sums.add_to(sums_ + i, room_ - i);
    }
  }

  /// Passes along columns get no help by what processors foresee.
  template <class Block>
  HWY_INLINE void prefetch(Block, int i) const {
    constexpr int kCellsOfCacheLine = 64 / sizeof(std::uint16_t);
    hwy::Prefetch(next_cost_ + i);
    if (past_caches_) return;
    for (int cell = 0; cell < kLanes<Block>; cell += kCellsOfCacheLine)
      hwy::Prefetch(next_sums_ + i + cell);
  }

  // Copies, for the reason that TermInRegisters gives.
  const int room_, count_, bits_;
  const bool begins_sums_, past_caches_, pairs_fit_;
  const std::uint16_t cost_weight_;
  const std::uint8_t *const cost_, *const next_cost_;
  std::uint16_t *const sums_, *const next_sums_;
  const std::uint8_t* classes_;
};

/// All paths of a pixel, in groups that fit the registers.
template <class Cell, int kPaths, int kTerms, bool kClasses>
class InVectors {
 public:
  /// Completes the layout: a few instructions for many pixels at a time.
  static HWY_INLINE void look_back(WalkedLine<Cell>& line) {
    const hn::CappedTag<int, LineLayout::kPixels> d;
    LineLayout& layout = line.layout;
    for (int k = 0; k < LineLayout::kPixels; k += kLanes<decltype(d)>) {
      const auto begin = hn::LoadU(d, layout.begin + k);
      const auto before = hn::Sub(begin, hn::Set(d, 1));
      const auto end = hn::Add(begin, hn::LoadU(d, layout.room + k));
      auto odd = hn::Zero(d);
      for (int t = 0; t < kPaths * kTerms; ++t) {
        const LinePixels<Cell> back = line.back[t].at(layout.first + k);
        hn::StoreU(hn::Add(hn::LoadU(d, back.zero), begin), d, layout.back[t] + k);
        odd = hn::Or(odd, hn::Or(hn::Sub(before, hn::LoadU(d, back.from)),
                                 hn::Sub(hn::LoadU(d, back.to), end)));
      }
      hn::StoreU(odd, d, layout.odd + k);
    }
  }

  static HWY_INLINE void extend(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k) {
    walk.find_penalties(line, k);
    const Term<Cell>* found = nullptr;
    if (HWY_UNLIKELY(!all_usual(line, k))) found = walk.find_terms(line, k);
    if (found != nullptr || !extend_one_block<kPaths, kTerms, kClasses>(walk, line, k)) {
      const hn::CappedTag<Cell, 64 / sizeof(Cell)> widest;
      extend_groups<0>(widest, walk, line, k, found);
    }
    if constexpr (kTerms == 2) {
      const Repeated minimum = *minima_of<kPaths>(line, k);
      if (HWY_UNLIKELY(minimum.template as<Cell>() == kInfinite<Cell>))
        line.pixels.lose(line.layout.first + k);
    }
  }

 private:
  static constexpr int kMaxTogether = kTerms == 1 || (kMasks && !kClasses) ? 4 : 2;
  static constexpr int kTogether = kPaths < kMaxTogether ? kPaths : kMaxTogether;

  /// Whether all terms count and are in one piece, as they usually do. One branch for all of them:
  /// guessing each wrong costs as much as guessing all.
  static HWY_INLINE bool all_usual(const WalkedLine<Cell>& line, int k) {
    if (line.layout.odd[k] < 0) return false;
    if constexpr (kTerms == 1) return true;
    bool some_lost = false;
    for (const std::atomic<bool>* line_lost : line.any_lost)
      some_lost |= line_lost->load(std::memory_order_relaxed);
    if (HWY_LIKELY(!some_lost)) return true;
    int lost = 0;
    for (int t = 0; t < kPaths * kTerms; ++t) lost |= line.back[t].lost[line.layout.first + k];
    return lost == 0;
  }

  template <int kFirst, class D>
  static HWY_INLINE void extend_groups(D d, const PassWalk<Cell>& walk, WalkedLine<Cell>& line,
                                       int k, const Term<Cell>* found) {
    Group<D, kFirst, kTogether, kPaths, kTerms, kClasses>(walk, line, k).run(walk, line, k, found);
    if constexpr (kFirst + kTogether < kPaths)
      extend_groups<kFirst + kTogether>(d, walk, line, k, found);
  }
};

/// Numbers of paths that occur have a kernel of their own.
template <class Cell, int kTerms, bool kClasses>
Advance<Cell> choose_paths(int paths) {
  constexpr int kFew = 2 / kTerms;  // of 4, 8 and 16 directions in two passes or in four
  if (paths == kFew) return advance<InVectors<Cell, kFew, kTerms, kClasses>, Cell>;
  if (paths == 2 * kFew) return advance<InVectors<Cell, 2 * kFew, kTerms, kClasses>, Cell>;
  if (paths == 4 * kFew) return advance<InVectors<Cell, 4 * kFew, kTerms, kClasses>, Cell>;
  return advance<Plainly, Cell>;
}

template <class Cell, int kTerms>
Advance<Cell> choose_classes(const PassStep& pass) {
  return pass.match_classes == 1 ? choose_paths<Cell, kTerms, false>(pass.paths)
                                 : choose_paths<Cell, kTerms, true>(pass.paths);
}

template <class Cell>
Advance<Cell> choose(const PassStep& pass) {
  if (pass.class_plane != 0) return advance<Plainly, Cell>;
  return pass.terms == 1 ? choose_classes<Cell, 1>(pass) : choose_classes<Cell, 2>(pass);
}

#endif

}  // namespace xgm::aggregation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
