// SPDX-License-Identifier: Apache-2.0
// calib.txt of Middlebury (2014, evaluation version 3) and ETH3D: lines "key=value".
#pragma once

#include <optional>
#include <string>

#include "xgm/data/scene_files.hpp"

namespace xgm::dataset {

struct CalibTxt {
  std::optional<Calibration> calibration;  ///< of cam0, doffs and baseline (mm), if all are there
  std::optional<Interval> disparities;     ///< [0, ndisp)
  cv::Size size;                           ///< of the images, px; 0 = not said
  std::string absent;                      ///< "cam0, baseline": keys that depth would need
};

/// Keys other than cam0, cam1, doffs, baseline, ndisp, width and height are not looked at. Throws
/// Error with file and line if one of these is faulty, appears twice, or if the cameras contradict
/// doffs or each other.
CalibTxt read_calib_txt(const std::string& file);

/// Reads the file and puts what it says into the scene; what it leaves open into scene.missing. An
/// empty name is told there too. Of a faulty file nothing is used; the fault goes to scene.faults.
void add_calib_txt(SceneFiles& scene, const std::string& file);

}  // namespace xgm::dataset
