// SPDX-License-Identifier: Apache-2.0
// Scenes: finds them in folders of data sets, and reads their images, masks and ground truth.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/ground_truth.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/pair_windows.hpp"
#include "xgm/data/scene_files.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/require_apart.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// A file that was read, and its role ("left", "right mask", "calibration", ...).
struct InputFile {
  std::string role;
  std::string file;
  FileIdentity identity;
};

struct Scene {
  std::string name{};
  ImagePair pair{};
  std::shared_ptr<const PairWindows> windows{};  ///< in place of the pair, if that is not held
  double windows_bytes = 0;                      ///< of memory that these hold
  std::optional<Interval> disparities{};         ///< to be searched, if it is known
  std::optional<Calibration> calibration{};
  GroundTruth truth{};
  std::vector<InputFile> inputs{};      ///< files that were read
  std::vector<std::string> notes{};     ///< what a reader should know about the images
  std::vector<std::string> warnings{};  ///< what is doubtful in the files

  cv::Size size() const { return windows ? windows->size() : pair.size(); }
};

/// The scenes in `folder`, sorted by name. Opens no image. The data set is
/// - `dataset` if given: the name of a plugin, its YAML ("{type: folder, left: ...}"), or a file of
///   such YAML;
/// - else dataset.yaml in the folder;
/// - else the data set that recognises the folder, among those that need no parameters.
/// Throws UsageError if none or several recognise it, or if `dataset` is faulty (with file, line
/// and remedy).
XGM_API std::vector<SceneFiles> find_scenes(const std::string& folder, const Registry& registry,
                                            const std::string& dataset = {});

/// The scene called `name`; without a name, the only scene, or the scene with the name of the
/// folder. Throws UsageError that lists all names.
XGM_API SceneFiles find_scene(const std::string& folder, const Registry& registry,
                              const std::string& name = {}, const std::string& dataset = {});

/// The file that describes the data set to find_scenes; empty if there is none.
XGM_API std::string dataset_file(const std::string& folder, const std::string& dataset = {});

/// The files of a scene without its truth, and those of a truth: as many as there are.
XGM_API std::vector<NamedFile> files_of(const SceneFiles& scene);
XGM_API std::vector<NamedFile> files_of(const TruthFiles& truth);

/// The scenes as a JSON list; unknown values are null.
XGM_API std::string to_json(const std::vector<SceneFiles>& scenes);

/// What is known to be wrong with a file of the scene; "" if nothing is.
XGM_API std::string fault_of(const SceneFiles& scene, const std::string& file);

/// Throws Error if the calibration is of images of another size: its cameras hold for that size
/// only.
XGM_API void require_calibrated_size(const SceneFiles& scene, cv::Size size);
/// The same of the disparities to search, if it is the calibration that gives them.
XGM_API void require_disparities_of_size(const SceneFiles& scene, cv::Size size);

/// Reads the images. Throws Error.
XGM_API Scene load_scene(const SceneFiles& files);
/// Looks at the images, which are read by windows (PairInFiles); temporary files are made in the
/// folder `scratch`. Throws Error.
XGM_API Scene open_scene(const SceneFiles& files, const std::string& scratch);

/// Reads the ground truth of a scene whose images have this size. Maps without a file are empty.
/// non_occluded is read from the mask, else derived from `visible`, else from both views by
/// cross_check. Throws Error, also if a file has another size.
XGM_API GroundTruth load_truth(const TruthFiles& files, cv::Size size);

/// Throws Error unless some pixel has a disparity by which a map is judged: see is_judged().
XGM_API void require_judgeable(const GroundTruth& truth);

/// The same files, to be recorded. Throws Error.
XGM_API std::vector<InputFile> identify_files(const std::vector<NamedFile>& files);

/// The left pixels that are visible in the right image, from the ground truth of both views: 255
/// where the true disparity of the right view at the corresponding pixel (rounded, halves to even)
/// is within 1 px of that of the left pixel, 128 where it is not, 0 where the truth is unknown.
/// `reverse` has the signs of a reverse map.
XGM_API cv::Mat1b cross_check(const cv::Mat1f& disparity, const cv::Mat1f& reverse);

/// Ranges [floor(min), ceil(max) + 1) from two float images (PFM, TIFF) of one size, in pixels. The
/// range of a pixel is empty if either value is not finite or means no data (read_disparities), or
/// if min is above max. Throws Error, also if all ranges are empty.
XGM_API Noted<DisparityRange> read_range_maps(const std::string& min_file,
                                              const std::string& max_file,
                                              const std::vector<double>& no_data = {});

/// A map, and how it is called in messages.
struct NamedMap {
  cv::Mat1f map;
  std::string name;
};

/// The same ranges from maps in memory; NaN gives none. Throws Error.
XGM_API DisparityRange range_of_maps(const NamedMap& min, const NamedMap& max);

/// The part of `interval` that is possible in an image `width` pixels wide: |d| < width.
XGM_API Interval clip_to_width(Interval interval, int width);

}  // namespace xgm
