// SPDX-License-Identifier: Apache-2.0
// Runs many surface pipelines on many satellite scenes: the paper's satellite table, pairwise
// surfaces averaged over the pairs of a region.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/evaluation/bench.hpp"
#include "xgm/geo/bench/surface_scene.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"

namespace xgm::geo {

/// The runs of a bench.
struct SurfaceBenchRequest {
  std::string output;
  std::vector<BenchPipeline> pipelines;  ///< of type surface
  std::vector<SurfaceScene> scenes;      ///< pairs, or whole scenes
  std::vector<FileIdentity> program{};   ///< results of another build of it are not reused
  int threads = 0;
};

/// One pipeline on one scene.
struct SurfaceCell {
  CellState state = CellState::not_run;
  std::string failure{};  ///< why it failed
  double seconds = 0;     ///< of the run, without reading the truth and writing
  double peak_bytes = 0;
  double search = 0;         ///< disparities that were searched, mean of the pixels
  SurfaceErrors errors{};    ///< as they are
  SurfaceErrors levelled{};  ///< with the median of dz taken out
  double spikes = 0;         ///< of the levelled surface, see spikes_on_flats()
  /// Of the disparities of the same run, non-occluded pixels; empty if they are not known.
  std::optional<Evaluation> disparities{};
};

struct XGM_API SurfaceBenchResult {
  SurfaceBenchRequest request;
  std::vector<SurfaceCell> cells;  ///< scene by scene
  bool interrupted = false;

  const SurfaceCell& at(std::size_t pipeline, std::size_t scene) const {
    return cells[scene * request.pipelines.size() + pipeline];
  }
  std::size_t failures() const;
};

struct SurfaceBenchHooks {
  /// Runs a pipeline on the images of a scene with its DEM and truth, and writes the files of
  /// `pipeline run` to the folder.
  std::function<RunOutcome(const BenchPipeline&, const SurfaceScene&, const std::string& folder)>
      run;
  std::function<void(const BenchProgress&)> tell = [](const BenchProgress&) {};
};

/// OUTPUT/PIPELINE/SET/SCENE.
XGM_API std::string cell_folder(const SurfaceBenchRequest& request, std::size_t pipeline,
                                std::size_t scene);

/// The files that decide of a surface beside the program: this library.
XGM_API std::string surface_library();

/// Runs all cells that are not done, scene by scene, and judges all surfaces. A cell is done if an
/// earlier bench ran it with the same program, resolved pipeline, images, DEM, truth and threads,
/// and its files have not changed since. Throws Error if the output cannot be written.
XGM_API SurfaceBenchResult run_surface_bench(const SurfaceBenchRequest& request,
                                             const SurfaceBenchHooks& hooks);

/// Averages only, for terminals.
XGM_API std::string surface_bench_text(const SurfaceBenchResult& result);
/// Averages, how figures of surfaces go with those of disparities, and scenes.
XGM_API std::string surface_bench_markdown(const SurfaceBenchResult& result);
/// One line per average and per cell, shares from 0 to 1.
XGM_API std::string surface_bench_csv(const SurfaceBenchResult& result);
/// All results and the resolved pipelines.
XGM_API std::string surface_bench_json(const SurfaceBenchResult& result);
/// The tables, and the surfaces side by side: pictures in the folders of the cells.
XGM_API std::string surface_bench_html(const SurfaceBenchResult& result);

/// Rank correlation of two lists of one length, -1 to 1: Spearman, The proof and measurement of
/// association between two things (1904); equal values share their mean rank. Pairs with a NaN do
/// not count; NaN if fewer than three are left, or one of the lists does not vary.
XGM_API double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace xgm::geo
