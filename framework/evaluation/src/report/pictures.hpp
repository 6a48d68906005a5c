// SPDX-License-Identifier: Apache-2.0
// Maps in the colours of the page.
#pragma once

#include <opencv2/core.hpp>

#include "report/encode.hpp"
#include "report/palette.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/ground_truth.hpp"

namespace xgm::report {

cv::Mat3b in_ramp(const cv::Mat1f& values, const Ramp& ramp, const Span& span);
cv::Mat3b in_classes(const cv::Mat1b& codes, const std::vector<Class>& classes);

/// Share of each class, 0 to 1.
std::vector<double> shares_of(const cv::Mat1b& codes, std::size_t classes);

/// |disparity - truth|, px, of the pixels shown; NaN where either is missing.
cv::Mat1f error_map(const DisparityMap& map, const cv::Mat1f& truth, const Sampling& sampling);

/// A Verdict per pixel. Pixels outside of the truth's non-occluded mask, if there is one, are not
/// judged.
cv::Mat1b verdicts(const DisparityMap& map, const GroundTruth& truth, double delta);

/// Of the pixels shown: first and last disparity of each pixel's interval, both included, NaN where
/// it is empty; and how many lie between them, ends included.
struct RangeMaps {
  cv::Mat1f first, last, count;
};
RangeMaps range_maps(const DisparityRange& range, const Sampling& sampling);

/// Disparities per pixel that the range holds, the mean of all pixels.
double mean_count(const DisparityRange& range);

}  // namespace xgm::report
