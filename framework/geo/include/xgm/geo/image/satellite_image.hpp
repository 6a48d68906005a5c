// SPDX-License-Identifier: Apache-2.0
// A satellite image: pixels in a file, the camera that took them, and what is known of the moment.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "xgm/geo/camera/rpc_camera.hpp"
#include "xgm/geo/image/acquisition.hpp"

namespace xgm::geo {

struct SatelliteImage {
  std::string name;   ///< unique among the images of a run
  std::string file;   ///< any raster that GDAL reads, in the camera's pixels
  int band = 0;       ///< from 1 on; 0: the mean of all bands
  std::string mask;   ///< file of the same size, nonzero where the image may be used; may be empty
  cv::Size size;      ///< px
  int bands = 1;      ///< that the file has
  int reduction = 1;  ///< each pixel is the mean of so many by so many of the file
  RpcCamera camera;
  Acquisition acquisition;
};

/// Opens the image, for its size, its camera and what find_acquisition() says of it; `camera_file`
/// is a file of read_rpc() in place of what the image itself holds. The camera is moved to the
/// pixels of a crop that says where it lies in the vendor's image (an origin without a CRS). Throws
/// Error, which names the file and the remedy.
XGM_API SatelliteImage open_image(const std::string& file, const std::string& camera_file = {});

/// The image with pixels that are means of `by` x `by` of this one's, and the camera of these. Rows
/// and columns that do not make up a pixel at the end are left out.
XGM_API SatelliteImage reduced(const SatelliteImage& image, int by);

/// Grey levels of a window; NaN outside of the image, where it has no data and where its mask is 0.
/// Of a reduced image: where that is so for more than half of what a pixel is the mean of.
XGM_API cv::Mat1f read_window(const SatelliteImage& image, cv::Rect window);

}  // namespace xgm::geo
