// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/penalty.hpp"

#include <algorithm>

namespace xgm {

PenaltyField::~PenaltyField() = default;
void PenaltyField::classify(Direction, int, std::span<std::uint8_t> base,
                            std::span<std::uint8_t> match) const {
  std::fill(base.begin(), base.end(), std::uint8_t{0});
  std::fill(match.begin(), match.end(), std::uint8_t{0});
}

}  // namespace xgm
