// SPDX-License-Identifier: Apache-2.0
// What the inner step of the aggregation is about: terms, and their bounds.
#pragma once

#include <cstdint>
#include <limits>

namespace xgm::aggregation {

/// The path cost of what cannot be matched. Saturating sums keep it.
template <class Cell>
inline constexpr Cell kInfinite = std::numeric_limits<Cell>::max();

inline constexpr int kMaxPaths = 8;  ///< of a pass
inline constexpr int kMaxTerms = 2;  ///< of a path
inline constexpr int kMaxSteps = kMaxPaths * kMaxTerms;
inline constexpr int kFarthest = 2;  ///< pixels and lines that a step leads back: knight's moves

/// A path cost, repeated over 32 bits: processors fill a vector with such a number as they load it,
/// with a single byte only in a further step.
class Repeated {
 public:
  Repeated() = default;
  explicit constexpr Repeated(std::uint8_t cost) : bits_(cost * 0x01010101U) {}
  explicit constexpr Repeated(std::uint16_t cost) : bits_(cost * 0x00010001U) {}

  std::uint32_t bits() const { return bits_; }
  template <class Cell>
  Cell as() const {
    return static_cast<Cell>(bits_);
  }

 private:
  std::uint32_t bits_ = 0;
};

/// In units of path costs.
struct StepPenalties {
  Repeated p1, p2;
};

/// What a path brings to p from q = p - x:
///   min(L(q, d), L(q, d+-1) + P1, min_i L(q, i) + P2) - min_i L(q, i).
template <class Cell>
struct Term {
  const Cell* previous;            ///< L(q, d) for p's disparities, and one more on either side
  const Repeated* minimum;         ///< min_i L(q, i)
  int step;                        ///< which one of the pass it is
  const StepPenalties* penalties;  ///< by match class
};

/// What is the same for all pixels of a pass.
struct PassStep {
  int paths = 0;
  int terms = 0;          ///< of each path, 1 or 2
  int match_classes = 1;  ///< the most that a table of penalties has
  int class_plane = 0;    ///< from one step's classes to the next one's; 0: step t's are in bit t
  bool past_caches = false;  ///< whether sums that are begun are written past the caches
  int bits = 0;              ///< fraction bits of path costs and sums
  int cost_weight = 1;       ///< how often C is in the sums beside what paths bring
  int p2 = 0;                ///< the largest, in units of path costs
  bool always_room = false;  ///< whether has_room_for_p2() holds for all path costs that occur
};

/// Whether the next pixel can add P2 to the least path cost. Nearly always so: its own C is all
/// that it holds, unless the range of disparities leaves out what was cheap before.
template <class Cell>
bool has_room_for_p2(Cell minimum, const PassStep& pass) {
  return minimum == kInfinite<Cell> || minimum + pass.p2 < kInfinite<Cell>;
}

/// Makes that room: `room` path costs less `least`, the least of them, which is 0 then.
template <class Cell>
void lower(Cell* costs, int room, Cell minimum);

}  // namespace xgm::aggregation
