// SPDX-License-Identifier: Apache-2.0
// What is matched: a pair of images from a folder or from files.
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
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// A file that was read, by the part it plays ("left", "right mask", "calibration", ...).
struct InputFile {
  std::string role;
  std::string file;
  FileIdentity identity;
};

struct Scene {
  std::string name{};
  ImagePair pair{};
  std::optional<Interval> disparities{};  ///< to be searched, if it is known
  std::optional<Calibration> calibration{};
  GroundTruth truth{};
  std::vector<InputFile> inputs{};   ///< files that were read
  std::vector<std::string> notes{};  ///< what a reader should know about the images
};

/// The scenes in `folder`, sorted by name; opens no image. Which data set it is:
/// - `dataset`, if it is given: a plugin's name, YAML of one ("{type: folder, left: ...}"), or a
///   file of such YAML;
/// - else dataset.yaml in the folder;
/// - else the one that recognises the folder, of all that need no parameters.
/// Throws UsageError if none or several do, or if what is given is faulty (with file, line and
/// remedy).
XGM_API std::vector<SceneFiles> find_scenes(const std::string& folder, const Registry& registry,
                                            const std::string& dataset = {});

/// The scene called `name`; without a name the only one, or the one that is called as the folder
/// is. Throws UsageError that lists the names there are.
XGM_API SceneFiles find_scene(const std::string& folder, const Registry& registry,
                              const std::string& name = {}, const std::string& dataset = {});

/// The scenes as a JSON list; what is not known is null.
XGM_API std::string to_json(const std::vector<SceneFiles>& scenes);

/// Reads the images. Throws Error.
XGM_API Scene load_scene(const SceneFiles& files);

/// Reads what is known to be true of a scene whose images are of this size; empty maps where there
/// is no file. non_occluded is the mask, else made from `visible`, else from both views by
/// cross_check. Throws Error, also if a file is of another size.
XGM_API GroundTruth load_truth(const TruthFiles& files, cv::Size size);

/// Throws Error unless some pixel has a disparity by which a map is judged: see is_judged().
XGM_API void require_judgeable(const GroundTruth& truth);

/// The truth among the files that were read, with their parts.
XGM_API std::vector<InputFile> identify_truth(const TruthFiles& files);

/// Which left pixels are seen in the right image, by the truth of both views: 255 where the truth
/// of the right view at the pixel pointed at (rounded, halves to even) is within 1 px of this
/// pixel's, 128 where not, 0 where there is no truth. `reverse` has the signs of a reverse map.
XGM_API cv::Mat1b cross_check(const cv::Mat1f& disparity, const cv::Mat1f& reverse);

/// Ranges [floor(min), ceil(max) + 1) from two PFM files of one size, in pixels. A pixel is empty
/// where either is not finite, or min is above max. Throws Error, also if all pixels are empty.
XGM_API DisparityRange read_range_maps(const std::string& min_file, const std::string& max_file);

/// The part of `interval` that an image `width` pixels wide can show at all: |d| < width.
XGM_API Interval clip_to_width(Interval interval, int width);

}  // namespace xgm
