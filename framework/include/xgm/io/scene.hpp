// SPDX-License-Identifier: Apache-2.0
// What is matched: a pair of images from a folder, from files, or the built-in sample.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/ground_truth.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/scene_files.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {

/// A file that was read, by the part it plays ("left", "right mask", "calibration", ...).
struct InputFile {
  std::string role;
  std::string file;
  FileIdentity identity;
};

struct Scene {
  std::string name;
  ImagePair pair;
  std::optional<Interval> disparities;
  GroundTruth truth;
  std::vector<InputFile> inputs;
  std::vector<std::string> notes;  ///< what a reader should know about the images
};

/// A Middlebury or ETH3D folder: im0 and im1 (png, ppm, pgm, pfm, tif, tiff, jpg, jpeg or bmp) and,
/// if they are there, calib.txt, of which only ndisp is used, the truth disp0GT.pfm and the mask
/// mask0nocc.png. Throws Error.
XGM_API SceneFiles find_scene(const std::string& folder);

/// Reads the images. Throws Error.
XGM_API Scene load_scene(const SceneFiles& files);

/// Reads what is true of a scene whose left image has this size; files that are not given leave
/// their maps empty. `visible` stands in for a missing mask of non-occluded pixels. Throws Error.
XGM_API GroundTruth load_truth(const TruthFiles& files, cv::Size size);

/// The truth among the files that were read, with their parts.
XGM_API std::vector<InputFile> identify_truth(const TruthFiles& files);

/// A small generated pair with known disparities, for a first run without data.
XGM_API Scene sample_scene();

/// Ranges [floor(min), ceil(max) + 1) from two PFM files of one size, in pixels. A pixel is empty
/// where either is not finite, or min is above max. Throws Error, also if all pixels are empty.
XGM_API DisparityRange read_range_maps(const std::string& min_file, const std::string& max_file);

/// The part of `interval` that an image `width` pixels wide can show at all: |d| < width.
XGM_API Interval clip_to_width(Interval interval, int width);

}  // namespace xgm
