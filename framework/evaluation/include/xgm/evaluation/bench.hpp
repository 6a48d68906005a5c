// SPDX-License-Identifier: Apache-2.0
// Runs many pipelines on many scenes: lists the runs, skips those that are done, collects results.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/scene_files.hpp"
#include "xgm/evaluation/bench_jobs.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm {

/// The values that a parameter takes, one after the other.
struct Sweep {
  std::string path;                 ///< "matcher.scale"
  std::vector<std::string> values;  ///< YAML
};
/// Parses "matcher.scale=4,8". Commas within [], {}, () and quotes belong to a value. Throws Error,
/// which names the option.
XGM_API Sweep parse_sweep(const std::string& text, const std::string& option = "--sweep");

/// One value for each swept parameter.
struct SweepPoint {
  std::string name;  ///< "+scale=4+directions=8"; "" without sweeps
  std::vector<Override> overrides;
};
/// All combinations, the last sweep changing fastest; one empty point without sweeps. Throws Error
/// if two sweeps have one path.
XGM_API std::vector<SweepPoint> sweep_points(const std::vector<Sweep>& sweeps);

/// A checked pipeline.
struct BenchPipeline {
  std::string name;  ///< "sgm8+directions=16"
  std::string file;
  std::vector<Override> overrides;
  std::string resolved;                   ///< Pipeline::resolved_json()
  std::optional<Interval> disparities{};  ///< Pipeline::disparities()
};

struct BenchScene {
  std::string set;          ///< the scenes of one set are averaged
  std::string data_folder;  ///< where find_scenes found it
  SceneFiles files;
  std::vector<FileIdentity> images{};  ///< of the images and their masks
};

/// The runs of a bench.
struct BenchRequest {
  std::string output;
  std::vector<BenchPipeline> pipelines;
  std::vector<BenchScene> scenes;
  std::vector<FileIdentity> program{};  ///< results of another build of the program are not reused
  int threads = 0;
};

/// How maps are evaluated.
struct BenchRules {
  std::vector<double> thresholds = usual_thresholds();  ///< px after scaling
  double scale = 1;   ///< see EvaluationRules; 0: the scale of each scene
  bool clip = false;  ///< whether to apply benchmark_clip, for scenes with known disparities
  /// A region of evaluate_regions. Empty: "non-occluded", or "all" for scenes without that region.
  std::string region;
};

/// The scenes in the given folders, found by find_scenes, each once. The scenes of one folder form
/// a set with the name of the folder. Scenes that are given one by one belong to the set of their
/// parent folder. If `names` is not empty, only these scenes. Throws Error, also for a name that no
/// scene has.
XGM_API std::vector<BenchScene> find_bench_scenes(const std::vector<std::string>& folders,
                                                  const Registry& registry,
                                                  const std::string& dataset,
                                                  const std::vector<std::string>& names);
/// Throws UsageError if nothing says which disparities to search in any scene, or which ones to
/// clip to in a scene without faults.
XGM_API void check_bench(const BenchRequest& request, const BenchRules& rules);
/// Reads the images of all scenes, to detect later changes. Throws Error.
XGM_API void identify_images(std::vector<BenchScene>& scenes);
/// Makes names unique and usable for folders: pipelines of the same name become "sgm8", "sgm8-2".
XGM_API void name_folders(std::vector<BenchPipeline>& pipelines);
/// What decides of a program's results: its file, the libraries and the plugin files given.
XGM_API std::vector<FileIdentity> identify_program(const std::string& program,
                                                   const std::vector<std::string>& plugins);

/// One pipeline on one scene.
struct BenchCell {
  CellState state = CellState::not_run;
  std::string failure;                      ///< why it failed
  double seconds = 0;                       ///< of matching
  double peak_bytes = 0;                    ///< of the run's process
  double evaluations = 0;                   ///< width * height * disparities searched
  double density = 0;                       ///< share of all pixels that have a disparity, 0 to 1
  std::vector<RegionEvaluation> regions{};  ///< empty without truth
};

struct XGM_API BenchResult {
  BenchRequest request;
  BenchRules rules;
  std::vector<BenchCell> cells;  ///< scene by scene
  bool interrupted = false;

  const BenchCell& at(std::size_t pipeline, std::size_t scene) const {
    return cells[scene * request.pipelines.size() + pipeline];
  }
  std::size_t failures() const;
  /// Whether some pipeline has finished the scene.
  bool any_done(std::size_t scene) const;
};

struct BenchHooks {
  /// Runs a pipeline on a scene, and writes the files of `pipeline run` to the folder.
  std::function<RunOutcome(const BenchPipeline&, const BenchScene&, const std::string& folder)> run;
  std::function<void(const BenchProgress&)> tell = [](const BenchProgress&) {};
};

/// The folder of one cell: OUTPUT/PIPELINE/SET/SCENE.
XGM_API std::string cell_folder(const BenchRequest& request, std::size_t pipeline,
                                std::size_t scene);

/// The files that a bench and its runs write to the folder of a cell.
XGM_API std::vector<std::string> cell_files(const std::string& folder);

/// Runs all cells that are not done, scene by scene, and evaluates all maps with the current ground
/// truth. A cell is done if an earlier bench ran it with the same program, resolved pipeline,
/// images, disparities and threads, and its files have not changed since. Holds one map in memory
/// at a time. After an interruption, only finished cells are evaluated. Throws Error if the output
/// cannot be written.
XGM_API BenchResult run_bench(const BenchRequest& request, const BenchRules& rules,
                              const BenchHooks& hooks);

}  // namespace xgm
