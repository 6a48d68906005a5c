// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/image.hpp"

#include <algorithm>

namespace xgm {

cv::Mat1f Image::grey() const {
  if (planes.size() < 3) return planes.empty() ? cv::Mat1f() : planes.front();
  // Piece by piece, so that what is in between stays in the cache. Of whole vectors, so that each
  // pixel is computed by the same instructions.
  constexpr int kRows = 64;
  cv::Mat1f grey(size());
  for (int y = 0; y < grey.rows; y += kRows) {
    const cv::Range rows(y, std::min(y + kRows, grey.rows));
    grey.rowRange(rows) = planes[0].rowRange(rows) * 0.114f + planes[1].rowRange(rows) * 0.587f +
                          planes[2].rowRange(rows) * 0.299f;
  }
  return grey;
}

}  // namespace xgm
