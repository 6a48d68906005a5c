// SPDX-License-Identifier: Apache-2.0
// Kind "penalty": the weights P1 and P2 of the discontinuity cost (the paper's Eq. 2), which may
// depend on the path direction, on the base pixel and on the matched pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// Step r of a path, in pixels (x to the right, y down): the pixel before p on the path is p - r.
struct Direction {
  int dx = 0;
  int dy = 0;
  friend bool operator==(const Direction&, const Direction&) = default;
};

/// P1: disparity step of one; P2: larger step. In units of the cost, 0 <= p1 <= p2.
struct PenaltyPair {
  int p1 = 0;
  int p2 = 0;
  friend bool operator==(const PenaltyPair&, const PenaltyPair&) = default;
};

/// The penalties of one direction: base pixels and match pixels are sorted into a few classes, and
/// each pair of classes has its P1 and P2. Constant penalties are one class each.
struct PenaltyTable {
  int base_classes = 1;
  int match_classes = 1;
  std::vector<PenaltyPair> entries{PenaltyPair{}};  ///< base_classes x match_classes, row-major

  const PenaltyPair& at(int base_class, int match_class) const {
    return entries[static_cast<std::size_t>(base_class * match_classes + match_class)];
  }
};

/// None if the table has an entry for each pair of classes, with 0 <= p1 <= p2.
XGM_API std::optional<Fault> fault_of(const PenaltyTable& table);

/// The penalties of one image pair, asked for direction by direction and row by row, so that no
/// maps need to be kept. Safe to use from several threads.
class XGM_API PenaltyField {
 public:
  virtual ~PenaltyField();
  virtual PenaltyTable table(Direction r) const = 0;
  /// Classes of the pixels of row y for the step from p - r to p. `base[x]` is the class of base
  /// pixel (x, y), `match[x]` that of match pixel (x, y); disparity d of base pixel x uses match[x
  /// - d]. Where p - r lies outside the image the class does not matter but must be in range. Both
  /// spans have the image's width. The default says class 0 everywhere.
  virtual void classify(Direction r, int y, std::span<std::uint8_t> base,
                        std::span<std::uint8_t> match) const;
};

class XGM_API Penalty : public Stage {
 public:
  static constexpr std::string_view kKind = "penalty";
  static constexpr std::string_view kMeaning =
      "weighs disparity steps between neighbours: P1 and P2";

  virtual std::unique_ptr<const PenaltyField> run(const ImagePair& pair,
                                                  const Context& context) const = 0;

  /// What every result is looked at for in a run: that there is one.
  static std::optional<Fault> fault_of(const std::unique_ptr<const PenaltyField>& result,
                                       const ImagePair& pair, const Context& context);
  /// The same penalties, which throw Error when a table or a class that is asked for is not sound:
  /// aggregations look entries up by class without a further look.
  static std::unique_ptr<const PenaltyField> watched(std::unique_ptr<const PenaltyField> field,
                                                     const Context& context);
};

}  // namespace xgm
