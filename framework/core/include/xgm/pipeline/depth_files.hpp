// SPDX-License-Identifier: Apache-2.0
// What is made of disparities where the cameras are known: depths, and points in space.
#pragma once

#include <cstddef>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm {

/// Files to write; what is empty is not asked for.
struct DepthFiles {
  std::string cloud{};  ///< NAME.ply
  std::string depth{};  ///< NAME.tiff; with a cloud NAME_depth.tiff beside it unless given

  bool empty() const { return cloud.empty() && depth.empty(); }
};

/// The same files with all names filled in. Throws UsageError, before any image is opened, if the
/// scene's cameras are not known, a file cannot be written, has another ending, or is one that the
/// scene is read from.
XGM_API DepthFiles check_depth_files(DepthFiles files, const SceneRequest& request);

/// Throws Error if depths are asked for, but the scene's cameras are those of images of another
/// size than these, which have been read.
XGM_API void require_cameras_of_size(const DepthFiles& files, const SceneRequest& request,
                                     cv::Size size);

/// Writes depths and points, in the unit of the baseline (mm), coloured by the left image. Returns
/// the number of points, 0 without a cloud. Throws Error.
XGM_API std::size_t write_depth_files(const DepthFiles& files, const DisparityMap& map,
                                      const Calibration& cameras, const Image& left);

}  // namespace xgm
