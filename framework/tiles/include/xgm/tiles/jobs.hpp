// SPDX-License-Identifier: Apache-2.0
// A pair matched by many processes, on one machine or many: a manifest of jobs, of which each can
// be done by itself once those that it needs are done. Which runs when, and where, is left to
// engines for that (Snakemake, Slurm). All share a file system.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/map_summary.hpp"
#include "xgm/io/pair_in_files.hpp"
#include "xgm/pipeline/scene_inputs.hpp"
#include "xgm/stage/run_facts.hpp"
#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

/// Looks at the whole scene for what preprocess stages have to know of it, or matches the coarse
/// levels of a pyramid as one image, or one tile.
struct TileJob {
  std::string name;                  ///< "fit", "coarse", or "tile_ROW_COLUMN" from 1 on
  std::vector<std::string> needs{};  ///< jobs that come before
  cv::Rect place{};                  ///< of the tile's part of the map; empty: of no tile
  double memory_bytes = 0;           ///< planned, of the whole process
  double seconds = 0;                ///< planned, of matching
};

struct JobManifest {
  std::string file{};           ///< where it stands; the jobs' results are in jobs/ beside it
  std::string pipeline_file{};  ///< that the pipeline was read from, for people
  std::string pipeline{};       ///< resolved
  std::vector<std::string> plugins{};  ///< files that it needs
  RunFacts facts{};                    ///< that stages of the jobs may ask for
  PairFiles images{};
  PairLook look{};                  ///< what was found in the images
  std::vector<InputFile> inputs{};  ///< what is read, by its content
  cv::Size size{};
  Interval disparities{};
  TileOptions tiles{};
  int threads = 1;  ///< of a job, that its memory and seconds are planned for
  std::vector<TileJob> jobs{};
};

/// Watches a small run for what jobs take. `inputs` was read by windows from `images`. Tiles have
/// the given size, or fit the inputs' memory limit. `file` need not be there. Throws UsageError if
/// tiles cannot be made of the request (range maps, too little memory).
XGM_API JobManifest plan_jobs(const Pipeline& pipeline, const SceneInputs& inputs,
                              const PairFiles& images, std::optional<cv::Size> size,
                              const std::string& file, const RunOptions& options);

/// Makes the manifest's folder and jobs/ in it. Throws Error.
XGM_API void write_manifest(const JobManifest& manifest);
/// Throws UsageError, which names the file, if it is no manifest.
XGM_API JobManifest read_manifest(const std::string& file);

/// Throws UsageError if there is no such job; it lists what there is.
XGM_API const TileJob& find_job(const JobManifest& manifest, const std::string& name);
/// Whether the job's results are there, as they were written, and of this manifest.
XGM_API bool is_done(const JobManifest& manifest, const TileJob& job);

/// Does a job unless it is done, which it tells by false. The pipeline is the manifest's. Results
/// are seen once they are complete; done again, or by two processes at once, they are the same
/// bytes. Throws Error if an image has changed or a job that it needs is not done.
XGM_API bool run_job(const JobManifest& manifest, const TileJob& job, const Pipeline& pipeline,
                     const RunOptions& options = {});

/// Writes the files of write_maps() to the folder, which is made if it is missing: the same bytes
/// as those of one process in the same tiles. Throws Error that lists the jobs which are not done.
XGM_API MapSummary join_jobs(const JobManifest& manifest, const std::string& folder);

}  // namespace xgm::tiles
