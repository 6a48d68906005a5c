// SPDX-License-Identifier: Apache-2.0
#include "plugins/preprocess/ransac_deskew/warp.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "xgm/base/parallel.hpp"

namespace xgm::ransac_deskew {
namespace {

constexpr int kBand = 64;  // rows that are warped at once; bounds the size of the maps

/// Whether the four rows that a cubic needs (those outside being repeated) have data in column x.
bool has_data(const Image& image, int x, double y) {
  const int last = image.size().height - 1;
  if (y < 0 || y > last) return false;
  if (image.valid.empty()) return true;
  const int row = static_cast<int>(std::floor(y));
  for (int k = row - 1; k <= row + 2; ++k)
    if (image.valid(std::clamp(k, 0, last), x) == 0) return false;
  return true;
}

/// Finite levels everywhere: even with weight zero, a NaN would spread.
std::vector<cv::Mat1f> clean_planes(const Image& image) {
  if (image.valid.empty()) return image.planes;
  std::vector<cv::Mat1f> planes;
  for (const cv::Mat1f& plane : image.planes) {
    planes.push_back(plane.clone());
    planes.back().setTo(0, image.valid == 0);
  }
  return planes;
}

}  // namespace

Image warp_rows(const Image& image, const RowModel& model, cv::Point origin) {
  const cv::Size size = image.size();
  const std::vector<cv::Mat1f> planes = clean_planes(image);
  Image result;
  result.valid.create(size);
  for (std::size_t c = 0; c < planes.size(); ++c) result.planes.emplace_back(size);

  parallel_for(0, (size.height + kBand - 1) / kBand, [&](int band) {
    const cv::Range rows(band * kBand, std::min(size.height, (band + 1) * kBand));
    cv::Mat1f map_x(rows.size(), size.width), map_y(rows.size(), size.width);
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const cv::Point place = cv::Point(x, y) + origin;
        const double source = place.y + model.at(place.x, place.y);
        map_x(y - rows.start, x) = static_cast<float>(x);
        // Rounded before the origin is taken off, so that parts are warped as the whole is.
        map_y(y - rows.start, x) = static_cast<float>(source) - static_cast<float>(origin.y);
        result.valid(y, x) = has_data(image, x, source - origin.y) ? 255 : 0;
      }
    }
    for (std::size_t c = 0; c < planes.size(); ++c) {
      cv::Mat warped = result.planes[c].rowRange(rows);
      cv::remap(planes[c], warped, map_x, map_y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
      warped = cv::min(cv::max(warped, 0), 255);  // a cubic overshoots at edges
    }
  });
  return result;
}

}  // namespace xgm::ransac_deskew
