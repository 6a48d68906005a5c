// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/cell_reason.hpp"

#include <cstddef>

namespace xgm::geo {

std::string_view to_string(CellReason reason) {
  constexpr std::array<std::string_view, kCellReasonCount> kNames{
      "height",     "not_seen", "outside_bounds", "occluded",       "no_match",     "ambiguous",
      "mismatched", "peak",     "filled",         "between_points", "too_few_pairs"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::array<double, kCellReasonCount> cell_shares(const cv::Mat1b& reasons) {
  std::array<double, kCellReasonCount> shares{};
  for (const std::uint8_t reason : reasons) shares[reason] += 1;
  for (double& share : shares) share /= static_cast<double>(reasons.total());
  return shares;
}

}  // namespace xgm::geo
