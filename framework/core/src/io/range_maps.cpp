// SPDX-License-Identifier: Apache-2.0
// Search ranges per pixel, from files.
#include <cmath>

#include "io/disparities.hpp"
#include "io/unscaled_image.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

Interval interval_of(float low, float high) {
  constexpr float kMaxDisparity = 1 << 20;  // no image is wider
  if (!(low <= high && std::abs(low) <= kMaxDisparity && std::abs(high) <= kMaxDisparity))
    return {};
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high)) + 1};
}

Noted<cv::Mat1f> read_range_map(const std::string& file, const std::vector<double>& no_data) {
  UnscaledImage raster = read_unscaled(file, no_data);
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
  return {range_of_maps({low, min_file}, {high, max_file}), std::move(warnings)};
}

DisparityRange range_of_maps(const NamedMap& min, const NamedMap& max) {
  const cv::Mat1f &low = min.map, &high = max.map;
  if (low.size() != high.size()) {
    throw Error(max.name + ": is " + size_text(high.size()) + " pixels but " + min.name + " is " +
                size_text(low.size()) + "; both maps must have the size of the left image");
  }
  DisparityRange range = DisparityRange::of_pixels(
      low.size(), [&](int y, int x) { return interval_of(low(y, x), high(y, x)); });
  if (range.hull().empty()) {
    throw Error(min.name + ": with " + max.name +
                " leaves no disparity at any pixel; is the smallest given first?");
  }
  return range;
}

}  // namespace xgm
