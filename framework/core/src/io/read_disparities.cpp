// SPDX-License-Identifier: Apache-2.0
// Disparities from files. Nothing that only looks like disparities becomes a number.
#include <cmath>
#include <limits>

#include "io/raster.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {
namespace {

bool has_equal_channels(const Raster& raster) {
  for (const cv::Mat1f& plane : raster.planes) {
    if (cv::countNonZero(plane != raster.planes.front()) > 0) return false;
  }
  return true;
}

bool holds_whole_numbers(const Raster& raster) {
  return raster.depth != CV_32F && raster.depth != CV_64F;
}

void require_measures(const Raster& raster, std::optional<double> divisor) {
  if (!has_equal_channels(raster)) {
    throw Error(raster.file +
                ": is a colour picture; its colours are no measures of disparity: give a PFM "
                "(disparity.pfm), or an image of one channel");
  }
  if (divisor && (!std::isfinite(*divisor) || *divisor == 0)) {
    throw Error(raster.file + ": the divisor of its values must be a number other than 0");
  }
  if (!divisor && holds_whole_numbers(raster)) {
    throw Error(raster.file + ": holds whole numbers (" + depth_name(raster.depth) +
                "), as pictures for display do: give a PFM (disparity.pfm), or say by which number "
                "they are divided to give px (--divisor, --truth-divisor; in a dataset.yaml "
                "truth_divisor, reverse_truth_divisor; KITTI: 256)");
  }
}

}  // namespace

cv::Mat1f read_disparities(const std::string& file, std::optional<double> divisor) {
  const Raster raster = read_raster(file);
  require_measures(raster, divisor);
  const cv::Mat1f stored = raster.planes.front();
  const bool zero_is_none = holds_whole_numbers(raster);
  cv::Mat1f map(stored.size());
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const bool none =
          (zero_is_none && stored(y, x) == 0) || (!raster.valid.empty() && raster.valid(y, x) == 0);
      map(y, x) = none ? std::numeric_limits<float>::quiet_NaN()
                       : static_cast<float>(stored(y, x) / divisor.value_or(1));
    }
  }
  return map;
}

DisparityMap read_map(const std::string& file, std::optional<double> divisor) {
  const cv::Mat1f disparities = read_disparities(file, divisor);
  DisparityMap map(disparities.size());
  for (int y = 0; y < disparities.rows; ++y) {
    for (int x = 0; x < disparities.cols; ++x) {
      if (std::isfinite(disparities(y, x))) map.set(y, x, disparities(y, x));
    }
  }
  return map;
}

}  // namespace xgm
