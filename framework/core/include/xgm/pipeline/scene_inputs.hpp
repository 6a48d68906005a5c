// SPDX-License-Identifier: Apache-2.0
// What is matched: asked for in a SceneRequest, checked before any image is opened, and read.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm {

/// Smallest and largest disparity of every pixel of the left image: two files of read_range_maps().
struct RangeMapFiles {
  std::string min{};
  std::string max{};
  std::vector<double> no_data{};  ///< values as stored that give no range
};

struct SceneRequest {
  /// The files of a pair (find_scene() fills them in for a folder of a data set), or a pair in
  /// memory with what is known of it.
  std::variant<SceneFiles, Scene> scene{};
  /// Searched instead of what the scene, or else the pipeline, says, px.
  std::optional<Interval> disparities{};
  std::string disparities_from = "caller";    ///< where `disparities` come from, for the record
  std::optional<RangeMapFiles> range_maps{};  ///< searched instead of any interval
  std::optional<DisparityRange> ranges{};     ///< the same in memory: range_of_maps()
  std::optional<TruthFiles> truth{};          ///< instead of the scene's own
  std::optional<double> memory_limit{};       ///< bytes that the process may take
  /// If set, images in files are read by windows (Scene::windows), with temporary files in this
  /// folder. No truth is read then.
  std::string scratch{};
};

/// A request that has been read.
struct SceneInputs {
  Scene scene;
  DisparityRange range;                ///< what lies beyond the images' width is cut off
  std::string disparities_from;        ///< where the range comes from, for people
  std::optional<double> memory_limit;  ///< the request's
  std::vector<std::string> warnings;   ///< of all files
  double reading_seconds = 0;
  Besides besides{};  ///< of the caller, for the limit
};

/// The files that the request is read from.
XGM_API std::vector<NamedFile> files_of(const SceneRequest& request);

/// What can be checked before an image is opened. Throws UsageError: a file that is missing, images
/// in memory that are no pair, no disparities, range maps that the pipeline cannot take,
/// or that are given as files and in memory.
XGM_API void check_scene(const SceneRequest& request, const Pipeline& pipeline);

/// Checks, and reads the images, range maps and truth. A faulty truth that comes with the scene is
/// warned of and not used; one that was asked for is an error. Throws UsageError like check_scene,
/// and Error for files that cannot be read or do not belong together.
XGM_API SceneInputs read_scene(const SceneRequest& request, const Pipeline& pipeline);

}  // namespace xgm
