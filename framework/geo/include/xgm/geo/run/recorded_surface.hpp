// SPDX-License-Identifier: Apache-2.0
// Runs a surface pipeline and keeps all there is to know of the run in a folder: what `pipeline
// run` does with satellite images, for any program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/evaluation/keeping.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#include "xgm/geo/run/surface_files.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm::geo {

/// The files that a run writes to its folder, run.json aside.
XGM_API std::vector<std::string> output_names(const SurfaceFiles& files);

struct SurfaceRecordRequest {
  std::string folder{};                     ///< made if it is missing; empty: nothing is written
  bool report = false;                      ///< also write report.html
  std::string geoid{};                      ///< heights are above it: "egm96"; empty: the ellipsoid
  std::vector<Override> overrides{};        ///< that the pipeline was loaded with, for the record
  std::vector<std::string> command_line{};  ///< for the record
  std::vector<NamedFile> inputs{};          ///< files read for this run beside those above
  std::optional<KeepRequest> keep{};        ///< of windows that are matched; none: nothing is kept
  /// Told what is done now ("reading the images").
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// How a run compares with the true heights of SurfaceFiles::truth.
struct SurfaceTruth {
  std::optional<SurfaceErrors> surface{};       ///< of the fused surface
  std::vector<RegionEvaluation> disparities{};  ///< of all pairs, see DisparityJudge
};

struct RecordedSurface {
  SurfaceResult result;
  double covered = 0;  ///< share of the grid's cells that have a height
  double seconds = 0;  ///< of the run, without writing
  SurfaceTruth truth;  ///< empty without a truth
  std::string record;  ///< what run.json holds
  std::vector<std::string> warnings{};
  std::vector<std::string> reused{};  ///< windows and levels that earlier runs have matched
  std::string reused_from{};          ///< folder
  std::string failure;  ///< why the surface is of no use; empty if it has a height anywhere
};

/// Writes to the folder, if there is one: dsm.tif (heights), pairs.tif and spread.tif (how many
/// pairs have seen a cell, and how far they disagree), gap.tif, source.tif, orthoimage.tif, dsm.png
/// and, last, run.json; if images were matched, also reasons.tif, cloud.ply and the cameras that
/// were used as NAME_rpc.txt. docs/satellite.md says what is in them. Throws UsageError for what is
/// wrong before anything is matched, else Error; if it is Cancelled, nothing is left of it.
XGM_API RecordedSurface record_surface(const Pipeline& pipeline, const SurfaceFiles& files,
                                       const SurfaceRecordRequest& request,
                                       const RunOptions& options = {});

}  // namespace xgm::geo
