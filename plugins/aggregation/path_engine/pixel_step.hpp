// SPDX-License-Identifier: Apache-2.0
// The operands of the inner step of the aggregation: terms, penalties, and what a pass fixes.
#pragma once

#include <cstdint>
#include <limits>

namespace xgm::aggregation {

/// Path cost of a disparity that cannot be matched. Saturating addition preserves it.
template <class Cell>
inline constexpr Cell kInfinite = std::numeric_limits<Cell>::max();

inline constexpr int kMaxPaths = 8;  ///< paths of a pass
inline constexpr int kMaxTerms = 2;  ///< terms of a path
inline constexpr int kMaxSteps = kMaxPaths * kMaxTerms;
inline constexpr int kFarthest = 2;  ///< pixels or lines that a knight's move leads back

/// A path cost repeated over 32 bits. Processors broadcast 32 bits to a vector as they load them; a
/// single byte needs another instruction.
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

/// P1 and P2 of a step, in units of path costs.
struct StepPenalties {
  Repeated p1, p2;
};

/// What a step reads at its previous pixel q = p - x. Its message to p is
///   min(L(q, d), L(q, d+-1) + P1, min_i L(q, i) + P2) - min_i L(q, i).
template <class Cell>
struct Term {
  const Cell* previous;            ///< L(q, d) for the disparities of p, and one more on each side
  const Repeated* minimum;         ///< min_i L(q, i)
  int step;                        ///< index of the step in the pass
  const StepPenalties* penalties;  ///< by match class
};

/// What is fixed for all pixels of a pass.
struct PassStep {
  int paths = 0;
  int terms = 0;             ///< terms of each path, 1 or 2
  int match_classes = 1;     ///< the largest number that a table of penalties has
  int class_plane = 0;       ///< bytes between the classes of two steps; 0: step t is bit t
  bool past_caches = false;  ///< whether the first values of sums bypass the caches
  int bits = 0;              ///< fraction bits of path costs and sums
  int cost_weight = 1;       ///< times C is in the sums, besides the messages
  int p2 = 0;                ///< the largest P2, in units of path costs
  bool always_room = false;  ///< whether has_room_for_p2() holds for all path costs that occur
};

/// Whether P2 can be added to the minimum of a pixel without reaching infinity. The minimum is
/// rarely more than a matching cost, unless the range of the pixel leaves out the disparities that
/// were cheap at the previous pixel.
template <class Cell>
bool has_room_for_p2(Cell minimum, const PassStep& pass) {
  return minimum == kInfinite<Cell> || minimum + pass.p2 < kInfinite<Cell>;
}

/// Makes room for P2: subtracts `minimum` from the `room` path costs of a pixel; infinite ones
/// stay. The minimum is 0 afterwards. No message changes, as messages are relative to the minimum.
template <class Cell>
void lower(Cell* costs, int room, Cell minimum);

}  // namespace xgm::aggregation
