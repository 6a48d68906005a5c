// SPDX-License-Identifier: Apache-2.0
// Pictures of results for display.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"
#include "xgm/io/sampling.hpp"

namespace xgm {

/// The map in the colours of "turbo" (blue: far, red: near), black where there is no disparity,
/// with a colour bar in pixels below. Colours span the 1st to the 99th percentile. The map is at
/// the top left, unscaled unless it is larger than pictures may be (Sampling::of_picture()); narrow
/// maps get a margin so that the legend fits.
XGM_API cv::Mat3b disparity_picture(const DisparityMap& map);

/// The same for any values (NaN: none) in `unit`. `light`, of their size or empty, darkens: 0 is
/// black, 1 leaves the colour as it is.
XGM_API cv::Mat3b colour_picture(const cv::Mat1f& values, const std::string& unit,
                                 const cv::Mat1f& light = {});

/// Of the picture of a map of so many pixels, legend included.
XGM_API cv::Size picture_size(cv::Size map);

/// The colour of a status in pictures, blue-green-red. The colours suit colour-blind readers.
XGM_API cv::Vec3b status_colour(Status status);

/// One colour per status, laid out alike, with a legend of names and shares below.
XGM_API cv::Mat3b status_picture(const DisparityMap& map);
/// The same of a part of the pixels, with the shares of all.
XGM_API cv::Mat3b status_picture(const DisparityMap& map,
                                 const std::array<double, kStatusCount>& shares);

/// The grey levels of an image rounded to 8 bit; pixels without data are black.
XGM_API cv::Mat3b picture(const Image& image);
/// The same with fewer pixels, each the mean of those that it stands for.
XGM_API cv::Mat3b picture(const Image& image, const Sampling& sampling);

/// Share of pixels of each status, 0 to 1, indexed by Status.
XGM_API std::array<double, kStatusCount> status_shares(const DisparityMap& map);

}  // namespace xgm
