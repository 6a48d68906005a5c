// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/image.hpp"

#include <algorithm>
#include <cstring>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

void require_planes(const Image& image, const std::string& which) {
  const std::size_t planes = image.planes.size();
  if (planes != 1 && planes != 3) {
    throw UsageError("the " + which + " image has " + std::to_string(planes) +
                     " planes; give one (grey) or three (blue, green, red)");
  }
  const bool planes_differ =
      std::any_of(image.planes.begin(), image.planes.end(),
                  [&](const cv::Mat1f& plane) { return plane.size() != image.size(); });
  if (planes_differ || (!image.valid.empty() && image.valid.size() != image.size())) {
    throw UsageError("planes and mask of the " + which + " image differ in size");
  }
}

bool is_same(const cv::Mat1f& a, const cv::Mat1f& b) {
  const std::size_t row_bytes = static_cast<std::size_t>(a.cols) * sizeof(float);
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a[y], b[y], row_bytes) != 0) return false;
  }
  return true;
}

}  // namespace

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

bool have_same_pixels(const Image& a, const Image& b) {
  return a.size() == b.size() &&
         std::equal(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(), is_same);
}

void require_sound(const ImagePair& pair) {
  if (pair.size().empty() || pair.match.size().empty()) {
    throw UsageError("the images are empty; give an image pair with pixels");
  }
  if (pair.match.size() != pair.size()) {
    throw UsageError("the images differ in size; a rectified pair has images of one size");
  }
  require_planes(pair.base, "left");
  require_planes(pair.match, "right");
}

}  // namespace xgm
