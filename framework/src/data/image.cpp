// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/image.hpp"

namespace xgm {

cv::Mat1f Image::grey() const {
  if (planes.size() < 3) return planes.empty() ? cv::Mat1f() : planes.front();
  return cv::Mat1f(planes[0] * 0.114f + planes[1] * 0.587f + planes[2] * 0.299f);
}

}  // namespace xgm
