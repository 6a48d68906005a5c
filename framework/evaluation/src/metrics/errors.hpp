// SPDX-License-Identifier: Apache-2.0
// The errors of a map's pixels, by the rules of an evaluation.
#pragma once

#include <cstdint>

#include "xgm/evaluation/metrics.hpp"

namespace xgm {

/// The benchmarks' value for "judge this pixel".
inline constexpr std::uint8_t kJudged = 255;

/// Throws Error unless `size` is that of the map.
void require_size(cv::Size size, cv::Size map, const char* what);

/// px after scaling, of a pixel that has both a disparity and a truth.
double error_at(const DisparityMap& map, const cv::Mat1f& truth, const EvaluationRules& rules,
                int y, int x);

/// Whether a pixel counts: it has a truth and is not masked out.
bool is_judged(const cv::Mat1f& truth, const cv::Mat1b& mask, int y, int x);

}  // namespace xgm
