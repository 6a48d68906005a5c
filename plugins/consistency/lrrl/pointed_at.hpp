// SPDX-License-Identifier: Apache-2.0
// Which pixels of a row the other view's disparities point at.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace xgm::lrrl {

/// Whole pixel position nearest to x - disparity; halves go to the right.
int target(int x, float disparity);

/// Sets pointed[x], for the pixels x of row y of one view, to whether the line of sight through x
/// meets the disparity function of the `other` view: target(q, d(q)) = x for some pixel q, or x
/// lies between the targets of q and q + 1 where both belong to one surface (their disparities
/// differ by at most `step`).
void mark_pointed_at(const cv::Mat1f& other, int y, double step, std::vector<char>& pointed);

}  // namespace xgm::lrrl
