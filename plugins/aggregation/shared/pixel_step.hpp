// SPDX-License-Identifier: Apache-2.0
// The inner step of the aggregation: extends all paths of a pass by one pixel, and adds what they
// bring to the pixel's sums. Everything around it is preparation, so that this is loops over cells.
#pragma once

#include <cstdint>
#include <limits>

namespace xgm::aggregation {

/// The path cost of what cannot be matched. Saturating sums keep it.
template <class Cell>
inline constexpr Cell kInfinite = std::numeric_limits<Cell>::max();

inline constexpr int kMostPaths = 8;  ///< of a pass
inline constexpr int kMostTerms = 2;  ///< of a path
inline constexpr int kFarthest = 2;   ///< pixels and lines that a step leads back: knight's moves

/// What a path brings to p from q = p - x:
///   min(L(q, d), L(q, d+-1) + P1, min_i L(q, i) + P2) - min_i L(q, i).
template <class Cell>
struct Term {
  const Cell* previous;  ///< L(q, d) for p's disparities, and one more on either side
  Cell least;            ///< min_i L(q, i)
  int step;              ///< which one of the pass it is
  const Cell* p1;        ///< by match class
  const Cell* p2;
};

template <class Cell>
struct Extension {
  Term<Cell> terms[kMostTerms];  ///< of the same path; their mean counts
  Cell* costs;                   ///< L(p, d), to be written, and a granule of infinite ones
};

/// One pixel of a pass. Slices have `room` cells, a multiple of VolumeShape::kGranule, and all of
/// these may be read and written; those behind `count` become infinite.
template <class Cell>
struct PixelStep {
  const std::uint8_t* cost;
  std::uint16_t* sums;
  const std::uint8_t* classes;    ///< match classes of all steps, of each disparity
  const std::uint8_t* next_cost;  ///< of a pixel that follows soon: worth having in the cache
  const std::uint16_t* next_sums;
  int count, room;
  Cell* least;  ///< min_i L(p, i) of each path, to be written; infinite if there is no match at all
  Extension<Cell> paths[kMostPaths];
};

/// What is the same for all pixels of a pass.
struct PassStep {
  int paths = 0;
  int terms = 0;          ///< of each path, 1 or 2
  int match_classes = 1;  ///< the most that a table of penalties has
  int class_plane = 0;    ///< from one step's classes to the next one's; 0: step t's are in bit t
  bool first = false;     ///< whether the sums are begun, with cost_weight * C, or added to
  int bits = 0;           ///< fraction bits of path costs and sums
  int cost_weight = 1;    ///< how often C is in the sums beside what paths bring
  int p2 = 0;             ///< the largest, in units of path costs
};

/// L = C + mean of the terms; sums += mean of the terms. Means are rounded to whole units, halves
/// to even: always up or down, errors would add up.
template <class Cell>
using ExtendPaths = void (*)(const PassStep& pass, const PixelStep<Cell>& pixel);

/// The plain code, which takes any pass: the reference of all others.
template <class Cell>
void extend_paths_plain(const PassStep& pass, const PixelStep<Cell>& pixel);

/// Whether the next pixel can add P2 to the least path cost. Nearly always so: its own C is all
/// that it holds, unless the range of disparities leaves out what was cheap before.
template <class Cell>
bool has_room_for_p2(Cell least, const PassStep& pass) {
  return least == kInfinite<Cell> || least + pass.p2 < kInfinite<Cell>;
}

/// Makes that room: `room` path costs less the least, which becomes 0.
template <class Cell>
void lower(Cell* costs, int room, Cell& least);

/// The fastest that takes this pass, for the SIMD target in use.
template <class Cell>
ExtendPaths<Cell> choose_extend_paths(const PassStep& pass);

}  // namespace xgm::aggregation
