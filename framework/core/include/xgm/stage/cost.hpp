// SPDX-License-Identifier: Apache-2.0
// Kind "cost": how unlike are a base pixel and its candidate in the match image?
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Cost : public Stage {
 public:
  static constexpr std::string_view kKind = "cost";
  static constexpr std::string_view kMeaning =
      "compares a base pixel with its candidates in the match image";

  /// Fills C(p, d) for every cell of `shape`: 0 (alike) to max_cost, or kNoMatch where the
  /// candidate (x - d, y) lies outside the match image or has no data. Never asked about masked
  /// base pixels: they have no cells.
  virtual CostVolume run(const ImagePair& pair, const VolumeShapePtr& shape,
                         const Context& context) const = 0;

  /// What every result is looked at for in a run: shape and bound; not its cells, which are too
  /// many.
  static std::optional<Fault> fault_of(const CostVolume& result, const ImagePair& pair,
                                       const VolumeShapePtr& shape, const Context& context);
};

}  // namespace xgm
