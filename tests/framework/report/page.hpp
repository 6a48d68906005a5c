// SPDX-License-Identifier: Apache-2.0
// Reads a report as a browser's program would.
#pragma once

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>

#include "xgm/evaluation/report.hpp"

namespace xgm::testing {

/// The JSON that the page hands to its program.
nlohmann::json page_data(const std::string& html);

/// A packed layer's numbers, by the formula that the page uses; NaN where there is none.
cv::Mat1d unpacked(const nlohmann::json& packed);

/// A scene of random disparities in [low, high] with some missing, truth, and one run.
ReportScene random_scene(cv::Size size, double low, double high, std::uint32_t seed);

}  // namespace xgm::testing
