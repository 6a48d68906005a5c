// SPDX-License-Identifier: Apache-2.0
// Runs a pipeline on a scene and keeps all there is to know of the run in a folder: what
// `pipeline run` does, for any program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/explain_pixels.hpp"
#include "xgm/evaluation/keeping.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/pipeline/depth_files.hpp"
#include "xgm/pipeline/scene_run.hpp"

namespace xgm {

/// What is to be recorded.
struct RecordRequest {
  std::string folder{};                     ///< made if it is missing
  std::vector<Override> overrides{};        ///< that the pipeline was loaded with, for the record
  std::vector<std::string> command_line{};  ///< for the record
  std::string dump{};                       ///< pattern of stages; see Dumper
  bool report = false;
  ExplainPixels explained{};
  DepthFiles depth{};
  /// Files that the program has read for this run beside those of the scene and the pipeline, such
  /// as plugin files. Like those they are never replaced.
  std::vector<NamedFile> inputs{};
  /// Asked, if set, whether and how the scene is matched in parts. Unless something is to be kept
  /// for which the whole is needed (reports, explanations, dumps, depths, a truth), the images are
  /// then read and the map is written part by part, and neither is in RecordedRun::run.
  ChooseParts parts{};
  /// None: nothing is kept. Reports, dumps and explanations show stages, of which none may be left
  /// out: runs with these keep nothing.
  std::optional<KeepRequest> keep{};
  bool holds_maps = false;  ///< the maps are wanted in RecordedRun::run in any case
  /// Told what is done now ("reading the images").
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

struct RecordedRun {
  SceneRun run;
  RunRecord record;        ///< what run.json holds
  DepthFiles depth;        ///< as they were written
  std::size_t points = 0;  ///< of the cloud
  std::string failure;     ///< why the map is of no use; empty if it has a disparity anywhere
};

/// Runs the pipeline and writes to the folder: disparity.pfm, disparity.png, status.png and, last,
/// run.json; report.html, explain.json, dump/ and depths as far as they are asked for. Files of an
/// earlier run, by the list in its run.json, are removed before. A map that is empty is written,
/// too, and `failure` says so. Throws UsageError for what is wrong before the images are matched, a
/// folder where another run is at work and files that would be lost included, else Error; run.json
/// is then missing. If it is Cancelled, nothing is left of it.
XGM_API RecordedRun record_scene(const Pipeline& pipeline, const SceneRequest& scene,
                                 const RecordRequest& request, const RunOptions& options = {});

/// The same without a folder: nothing is written, and the record lists no outputs. Throws
/// UsageError if `request` asks for files.
XGM_API RecordedRun record_in_memory(const Pipeline& pipeline, const SceneRequest& scene,
                                     const RecordRequest& request, const RunOptions& options = {});

}  // namespace xgm
