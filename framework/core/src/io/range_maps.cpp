// SPDX-License-Identifier: Apache-2.0
// Search ranges per pixel, from files.
#include <cmath>

#include "io/disparities.hpp"
#include "io/raster.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

Interval interval_of(float low, float high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high) return {};
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high)) + 1};
}

Noted<cv::Mat1f> read_range_map(const std::string& file, const std::vector<double>& no_data) {
  UnscaledImage raster = read_raster(file, no_data);
  require_no_picture(raster);
  if (raster.holds_whole_numbers()) {
    throw Error(file + ": holds whole numbers (" + depth_name(raster.depth) +
                "); a range map is a float image: give a PFM or a TIFF of float");
  }
  return to_disparities(std::move(raster), 1);
}

}  // namespace

Noted<DisparityRange> read_range_maps(const std::string& min_file, const std::string& max_file,
                                      const std::vector<double>& no_data) {
  std::vector<std::string> warnings;
  const cv::Mat1f low = take(read_range_map(min_file, no_data), warnings);
  const cv::Mat1f high = take(read_range_map(max_file, no_data), warnings);
  if (low.size() != high.size()) {
    throw Error(max_file + ": is " + size_text(high.size()) + " pixels but " + min_file + " is " +
                size_text(low.size()) + "; both maps must have the size of the left image");
  }
  auto range = DisparityRange::of_pixels(
      low.size(), [&](int y, int x) { return interval_of(low(y, x), high(y, x)); });
  if (range.hull().empty()) {
    throw Error(min_file + ": with " + max_file +
                " leaves no disparity at any pixel; is the order min.pfm,max.pfm?");
  }
  return {std::move(range), std::move(warnings)};
}

}  // namespace xgm
