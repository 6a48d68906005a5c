// SPDX-License-Identifier: Apache-2.0
#include "plugins/preprocess/ransac_deskew/warp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "xgm/base/parallel.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm::ransac_deskew {
namespace {

// What is warped at once: bounds the size of the maps, and cv::remap takes no side of 32767 pixels.
const cv::Size kBlock(8192, 64);

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

/// The rows of the image that `block` of the result is made of. Where they end before the image
/// does, no pixel reads as far.
cv::Range source_rows(const cv::Rect& block, const RowModel& model, cv::Point origin, int height) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const int x : {block.x, block.br().x - 1}) {
    for (const int y : {block.y, block.br().y - 1}) {  // the model is linear
      const double source = y + model.at(x + origin.x, y + origin.y);
      first = std::min(first, source);
      last = std::max(last, source);
    }
  }
  constexpr int kCubicRows = 3;  // one more than it reads, for what is rounded
  const auto row = [height](double y) {
    return static_cast<int>(std::clamp(y, 0.0, height - 1.0));
  };
  return {row(std::floor(first) - kCubicRows), row(std::ceil(last) + kCubicRows) + 1};
}

}  // namespace

Image warp_rows(const Image& image, const RowModel& model, cv::Point origin) {
  const cv::Size size = image.size();
  const std::vector<cv::Mat1f> planes = clean_planes(image);
  Image result;
  result.valid.create(size);
  for (std::size_t c = 0; c < planes.size(); ++c) result.planes.emplace_back(size);

  const std::vector<cv::Rect> blocks = image_parts(size, kBlock);
  parallel_for(0, static_cast<int>(blocks.size()), [&](int i) {
    const cv::Rect& block = blocks[static_cast<std::size_t>(i)];
    const cv::Range rows = source_rows(block, model, origin, size.height);
    cv::Mat1f map_x(block.size()), map_y(block.size());
    for (int y = block.y; y < block.br().y; ++y) {
      for (int x = block.x; x < block.br().x; ++x) {
        const cv::Point place = cv::Point(x, y) + origin;
        const double source = place.y + model.at(place.x, place.y);
        const cv::Point at = cv::Point(x, y) - block.tl();
        map_x(at) = static_cast<float>(at.x);
        // Rounded before whole numbers are taken off, so that parts are warped as the whole is.
        map_y(at) = static_cast<float>(source) - static_cast<float>(origin.y + rows.start);
        result.valid(y, x) = has_data(image, x, source - origin.y) ? 255 : 0;
      }
    }
    for (std::size_t c = 0; c < planes.size(); ++c) {
      const cv::Mat1f seen = planes[c](rows, {block.x, block.br().x});
      cv::Mat warped = result.planes[c](block);
      cv::remap(seen, warped, map_x, map_y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
      warped = cv::min(cv::max(warped, 0), 255);  // a cubic overshoots at edges
    }
  });
  return result;
}

}  // namespace xgm::ransac_deskew
