// SPDX-License-Identifier: Apache-2.0
// Why a cell of a surface has a height, or has none.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm::geo {

/// In the order of how near a cell came to a height; the numbers are those of reasons.tif. If pairs
/// differ, the one counts that came nearest.
enum class CellReason : std::uint8_t {
  height,    ///< has one
  not_seen,  ///< not shown by both images of any pair: outside of them, of the area, or masked
  outside_bounds,  ///< the range prior left nothing to search where it is seen
  occluded,        ///< hidden in one of the images
  no_match,        ///< nothing that was searched could be matched
  ambiguous,       ///< the best disparity was not clearly better than the others
  mismatched,      ///< failed the consistency check, although visible in both images
  peak,            ///< belonged to a segment too small to be trusted
  filled,          ///< its disparity was interpolated, and is not triangulated
  between_points,  ///< the pixels that show it have points, but in the cells around
  too_few_pairs,   ///< has heights, but of fewer pairs than the fusion asks for
};
inline constexpr int kCellReasonCount = 11;

/// The name in files: "not_seen", ...
XGM_API std::string_view to_string(CellReason reason);

/// Share of the cells of each reason, 0 to 1, indexed by CellReason. The sum is 1.
XGM_API std::array<double, kCellReasonCount> cell_shares(const cv::Mat1b& reasons);

}  // namespace xgm::geo
