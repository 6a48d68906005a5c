// SPDX-License-Identifier: Apache-2.0
// Every pipeline on every scene, as jobs; and what their results amount to.
#include "xgm/geo/bench/surface_bench.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/geo/evaluation/spikes.hpp"
#include "xgm/pipeline/installation.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;
constexpr int kFormat = 1;
constexpr const char* kSurface = "dsm.tif";

std::string identity(const SurfaceBenchRequest& request, const BenchPipeline& pipeline,
                     const SurfaceScene& scene) {
  std::vector<FileIdentity> files;
  for (const NamedFile& file : files_of(scene.files)) files.push_back(identify_file(file.file));
  Json dem = Json::array();  // with datums
  for (const std::string& name : scene.files.dem) dem.push_back(name);
  return Json{{"format", kFormat},
              {"program", identity_json(request.program)},
              {"pipeline", Json::parse(pipeline.resolved)},
              {"dem", dem},
              {"area", scene.files.area},
              {"band", scene.files.band},
              {"files", identity_json(files)},
              {"threads", request.threads}}
      .dump();
}

/// The figures of a record. Throws Error if one is missing.
SurfaceCell read_record(const std::string& folder) {
  const std::string file = (fs::path(folder) / "run.json").string();
  const std::string text = read_file(file);
  SurfaceCell cell;
  try {
    const Json json = Json::parse(text);
    cell.seconds = json.at("seconds").number();
    cell.peak_bytes = json.at("peak_memory_bytes").number();
    cell.search = json.at("search").at("disparities_per_pixel").number();
    const Json* const truth = json.find("truth");
    const Json* const regions = truth != nullptr ? truth->find("disparities") : nullptr;
    if (regions != nullptr) {
      for (const Json& region : *regions) {
        if (region.at("region").text() == "non-occluded") {
          cell.disparities = evaluation_of(region);
        }
      }
    }
  } catch (const Error& error) {
    throw Error(file + ": is no record of a surface (" + error.what() +
                "); remove it and run again");
  }
  cell.state = CellState::done;
  return cell;
}

SurfaceCell judge(const std::string& folder, const Raster& truth) {
  SurfaceCell cell = read_record(folder);
  const Raster surface = read_raster((fs::path(folder) / kSurface).string());
  cv::Mat1f heights = on_grid_of(surface, truth);
  cell.errors = compare_surfaces(heights, truth.values);
  heights -= cell.errors.signed_median;
  cell.levelled = compare_surfaces(heights, truth.values);
  cell.spikes = spikes_on_flats(heights, truth.values, std::abs(truth.place.step_x));
  return cell;
}

}  // namespace

std::string cell_folder(const SurfaceBenchRequest& request, std::size_t pipeline,
                        std::size_t scene) {
  const SurfaceScene& where = request.scenes[scene];
  return (fs::path(request.output) / request.pipelines[pipeline].name / where.set / where.name)
      .string();
}

std::string surface_library() { return file_of(reinterpret_cast<const void*>(&run_surface_bench)); }

SurfaceBenchResult run_surface_bench(const SurfaceBenchRequest& request,
                                     const SurfaceBenchHooks& hooks) {
  SurfaceBenchResult result{request, {}};
  const std::size_t pipelines = request.pipelines.size();
  std::vector<BenchJob> jobs;
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < pipelines; ++i) {
      jobs.push_back({.pipeline = request.pipelines[i].name,
                      .scene = request.scenes[scene].name,
                      .folder = cell_folder(request, i, scene),
                      .identity = identity(request, request.pipelines[i], request.scenes[scene]),
                      .result = kSurface});
    }
  }
  result.cells.resize(jobs.size());
  Raster truth;  // of the scene that is being judged
  std::size_t truth_of = request.scenes.size();
  const auto run = [&](std::size_t i) {
    return hooks.run(request.pipelines[i % pipelines], request.scenes[i / pipelines],
                     jobs[i].folder);
  };
  const auto judge_job = [&](std::size_t i) {
    if (truth_of != i / pipelines) truth = judged_truth(request.scenes[i / pipelines]);
    truth_of = i / pipelines;
    result.cells[i] = judge(jobs[i].folder, truth);
    return JobFigures{.seconds = result.cells[i].seconds, .peak_bytes = result.cells[i].peak_bytes};
  };
  const auto fail = [&](std::size_t i, const std::string& why) {
    result.cells[i] = {.state = CellState::failed, .failure = why};
  };
  result.interrupted =
      run_jobs(jobs, {.run = run, .judge = judge_job, .fail = fail, .tell = hooks.tell});
  return result;
}

std::size_t SurfaceBenchResult::failures() const {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](const auto& cell) {
    return cell.state == CellState::failed;
  }));
}

}  // namespace xgm::geo
