// SPDX-License-Identifier: Apache-2.0
// Numbers as the command line gives them: all of the text must be the value.
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/data/disparity_range.hpp"

namespace xgm::cli {

/// The items of a list, without blanks around them.
std::vector<std::string> split_at_commas(const std::string& text);

/// A finite number and nothing else.
std::optional<double> parse_number(std::string_view text);
/// A whole number and nothing else; it may have a sign.
std::optional<int> parse_whole(std::string_view text);

/// "-9999" or "0,65535": values that mean no data; empty if the text is. Throws UsageError, which
/// names the option.
std::vector<double> parse_no_data(const std::string& text, const std::string& option);

/// "MIN:MAX", both included. Throws UsageError, which names the option.
Interval parse_disparities(const std::string& text, const std::string& option = "--disparities");

/// "2.5GB", "800 MB", "1GiB", "2g" as bytes. Throws UsageError, which names the option.
double parse_bytes(const std::string& text, const std::string& option);

/// "2000x1000", px; "auto": empty. Throws UsageError.
std::optional<cv::Size> parse_tiles(const std::string& text);

}  // namespace xgm::cli
