// SPDX-License-Identifier: Apache-2.0
// The errors of a map's pixels, by the rules of an evaluation.
#pragma once

#include "xgm/evaluation/metrics.hpp"

namespace xgm {

/// Throws Error unless `size` is that of the map.
void require_size(cv::Size size, cv::Size map, const char* what);

/// px after scaling, of a pixel that has both a disparity and a truth.
double error_at(const DisparityMap& map, const cv::Mat1f& truth, const EvaluationRules& rules,
                int y, int x);

}  // namespace xgm
