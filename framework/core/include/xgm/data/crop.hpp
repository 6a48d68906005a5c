// SPDX-License-Identifier: Apache-2.0
// Windows of images, maps and ranges, with pixels of their own.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"

namespace xgm {

/// `window` lies within the size of what it is cut out of.
XGM_API Image crop(const Image& image, const cv::Rect& window);
XGM_API ImagePair crop(const ImagePair& pair, const cv::Rect& window);
XGM_API DisparityMap crop(const DisparityMap& map, const cv::Rect& window);
XGM_API MatchResult crop(const MatchResult& maps, const cv::Rect& window);

}  // namespace xgm
