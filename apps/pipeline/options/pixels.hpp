// SPDX-License-Identifier: Apache-2.0
// Pixels that are to be explained, as the command line gives them.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/explain_pixels.hpp"

namespace xgm::cli {

/// "X,Y" or "every=N", any number of them. Throws UsageError.
ExplainPixels parse_explain(const std::vector<std::string>& texts);

/// "X" and "Y" of the command line. Throws UsageError.
cv::Point parse_pixel(const std::string& x, const std::string& y);

}  // namespace xgm::cli
