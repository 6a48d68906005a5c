// SPDX-License-Identifier: Apache-2.0
// Disparities from files. Nothing that only looks like disparities becomes a number.
#include <cmath>
#include <limits>

#include "io/disparities.hpp"
#include "io/marks.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

bool has_equal_channels(const UnscaledImage& raster) {
  for (const cv::Mat1f& plane : raster.planes) {
    if (cv::countNonZero(plane != raster.planes.front()) > 0) return false;
  }
  return true;
}

void require_divisor(const UnscaledImage& raster, std::optional<double> divisor) {
  if (divisor && (!std::isfinite(*divisor) || *divisor == 0)) {
    throw Error(raster.file + ": the divisor of its values must be a number other than 0");
  }
  if (!divisor && raster.holds_whole_numbers()) {
    throw Error(raster.file + ": holds whole numbers (" + depth_name(raster.depth) +
                "), as pictures for display do: give a PFM (disparity.pfm), or say by which number "
                "they are divided to give px (--divisor, --truth-divisor; in a dataset.yaml "
                "truth_divisor, reverse_truth_divisor; KITTI: 256)");
  }
}

void mask_zeros(UnscaledImage& raster) {
  const cv::Mat1b known(raster.planes.front() != 0);
  raster.valid = raster.valid.empty() ? known : cv::Mat1b(raster.valid & known);
}

}  // namespace

void require_no_picture(const UnscaledImage& raster) {
  if (has_equal_channels(raster)) return;
  throw Error(raster.file +
              ": is a colour picture; its colours are no measures of disparity: give a PFM "
              "(disparity.pfm), or an image of one channel");
}

Noted<cv::Mat1f> to_disparities(UnscaledImage raster, double divisor) {
  if (raster.holds_whole_numbers()) mask_zeros(raster);
  Noted<cv::Mat1f> read{cv::Mat1f(raster.size()), mask_marks_of_map(raster, divisor)};
  const cv::Mat1f& stored = raster.planes.front();
  for (int y = 0; y < stored.rows; ++y) {
    for (int x = 0; x < stored.cols; ++x) {
      read.value(y, x) = raster.is_valid(y, x) ? static_cast<float>(stored(y, x) / divisor)
                                               : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return read;
}

Noted<cv::Mat1f> read_disparities(const std::string& file, std::optional<double> divisor,
                                  const std::vector<double>& no_data) {
  UnscaledImage raster = read_unscaled(file, no_data);
  require_no_picture(raster);
  require_divisor(raster, divisor);
  return to_disparities(std::move(raster), divisor.value_or(1));
}

Noted<DisparityMap> read_map(const std::string& file, std::optional<double> divisor,
                             const std::vector<double>& no_data) {
  const auto [disparities, warnings] = read_disparities(file, divisor, no_data);
  DisparityMap map(disparities.size());
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (std::isfinite(disparities(y, x))) map.set(y, x, disparities(y, x));
    }
  }
  return {std::move(map), warnings};
}

}  // namespace xgm
