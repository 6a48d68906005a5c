// SPDX-License-Identifier: Apache-2.0
// Key points found in both views.
#pragma once

#include <vector>

#include "plugins/preprocess/ransac_deskew/row_model.hpp"
#include "xgm/data/pair_windows.hpp"

namespace xgm::ransac_deskew {

struct KeyPointOptions {
  int count = 4000;    ///< wanted per image
  double ratio = 0.8;  ///< the best match's distance must be below this share of the second best's
  double max_dy = 16;  ///< pixels
};

/// Lowe: Distinctive image features from scale-invariant keypoints (IJCV 2004): SIFT key points
/// that choose each other and pass the ratio test, rows at most max_dy apart. Pixels without data
/// and their surroundings are not looked at. Images of more than a megapixel (2^20) are looked at
/// in half the size, those of more than 16 in four bands of rows.
std::vector<Correspondence> match_key_points(const PairWindows& pair,
                                             const KeyPointOptions& options);

/// Pixels of each image that are looked at, of half the size where that is done.
double key_point_pixels(cv::Size size);

/// Memory that it takes, at most at one time.
double key_point_bytes(cv::Size size, int threads);

}  // namespace xgm::ransac_deskew
