// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/run/recorded_surface.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "run/search_volume.hpp"
#include "run/surface_outputs.hpp"
#include "run/truth_record.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"
#include "xgm/stage/observers.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;

std::vector<NamedFile> files_read(const Pipeline& pipeline, const SurfaceFiles& files,
                                  const SurfaceRecordRequest& request) {
  std::vector<NamedFile> read{{"pipeline", pipeline.file()}};
  for (const std::string& image : files.images) read.push_back({"image", image});
  for (const std::string& cloud : files.clouds) read.push_back({"cloud", cloud});
  for (const std::string& mask : files.masks) read.push_back({"mask", mask});
  if (!files.dem.empty()) read.push_back({"DEM", dem_file(files.dem)});
  if (!files.truth.empty()) read.push_back({"truth", files.truth});
  read.insert(read.end(), request.inputs.begin(), request.inputs.end());
  return read;
}

std::vector<NamedFile> files_written(const SurfaceFiles& files, const std::string& folder) {
  std::vector<NamedFile> written;
  const auto add = [&](const std::string& name) {
    written.push_back({"--output", (fs::path(folder) / name).string()});
  };
  for (const std::string& name : output_names(files)) add(name);
  add(kRecordFile);
  return written;
}

void check(const SurfaceFiles& files) {
  if (!files.clouds.empty()) {
    if (files.images.empty() && files.masks.empty() && files.dem.empty()) return;
    throw UsageError("--clouds: clouds are made a surface of without images, masks and DEM");
  }
  if (files.images.size() < 2) throw UsageError("--images: give at least two satellite images");
  if (!files.masks.empty() && files.masks.size() != files.images.size()) {
    throw UsageError("--masks: give one mask for each of the " +
                     std::to_string(files.images.size()) + " images, or none");
  }
  std::set<std::string> names;
  for (const std::string& image : files.images) {
    if (!names.insert(fs::path(image).stem().string()).second) {
      throw UsageError(image + ": another image has the same name; give them different names");
    }
  }
}

SurfaceRequest read_request(const SurfaceFiles& files) {
  SurfaceRequest request;
  for (std::size_t i = 0; i < files.images.size(); ++i) {
    request.images.push_back(open_image(files.images[i]));
    if (!files.masks.empty()) request.images.back().mask = files.masks[i];
  }
  if (!files.dem.empty()) request.dem = read_dem(files.dem);
  request.area = files.area;
  return request;
}

/// The surface, of images or of clouds. `truth`, unless null, is told of all that is matched.
std::function<SurfaceResult(const Context&)> make_job(const SurfaceFamily& family,
                                                      const SurfaceFiles& files,
                                                      TruthRecord* truth) {
  if (files.clouds.empty()) {
    SurfaceRequest images = read_request(files);
    if (truth != nullptr) {
      images.matched = [truth](const auto&... window) { truth->add(window...); };
    }
    return [&family, request = std::move(images)](const Context& context) {
      return family.run(request, context);
    };
  }
  // Shared, since the clouds are large and a function must be able to be copied.
  const auto request =
      std::make_shared<CloudRequest>(CloudRequest{read_clouds(files.clouds), files.area});
  return [&family, request](const Context& context) {
    return family.rasterise(std::move(*request), context);
  };
}

Json truth_json(const SurfaceTruth& truth) {
  Json json = Json::object();
  if (truth.surface) json["surface"] = to_json(*truth.surface);
  if (!truth.disparities.empty()) json["disparities"] = to_json(truth.disparities);
  return json;
}

Json record_of(const Pipeline& pipeline, const SurfaceRecordRequest& request,
               const std::vector<NamedFile>& inputs, const RecordedSurface& recorded,
               const RunOptions& options) {
  Json json;
  json["format"] = 1;
  json["versions"] = versions_json();
  json["command_line"] = request.command_line;
  json["pipeline"] = {{"file", pipeline.file()},
                      {"overrides", to_json(request.overrides)},
                      {"resolved", Json::parse(pipeline.resolved_json())}};
  json["scene"] = {{"inputs", to_json(identify_files(inputs))}};
  json["grid"] = grid_json(recorded.result.grid);
  json["pairs"] = pairs_json(recorded.result);
  json["covered_share"] = recorded.covered;
  json["cells"] = cells_json(recorded.result);
  json["threads"] = options.threads > 0 ? options.threads : thread_count();
  json["seconds"] = recorded.seconds;
  return json;
}

/// What is wrong goes to the record, too.
class Warnings final : public Observer {
 public:
  void log(LogLevel level, const StagePlace& place, const std::string& text) override {
    if (level == LogLevel::warning) all.push_back(place.path + ": " + text);
  }
  std::vector<std::string> all;
};

double share_of_heights(const cv::Mat1f& heights) {
  const auto count =
      std::count_if(heights.begin(), heights.end(), [](float h) { return !std::isnan(h); });
  return static_cast<double>(count) / static_cast<double>(heights.total());
}

}  // namespace

RecordedSurface record_surface(const Pipeline& pipeline, const SurfaceFiles& files,
                               const SurfaceRecordRequest& request, const RunOptions& options) {
  const auto* const family = dynamic_cast<const SurfaceFamily*>(&pipeline.family());
  if (family == nullptr) throw UsageError(pipeline.file() + ": is no pipeline of type surface");
  check(files);
  const std::vector<NamedFile> inputs = files_read(pipeline, files, request);
  RunFolder folder(request.folder, files_written(files, request.folder), inputs);
  request.tell(files.clouds.empty() ? "reading the images" : "reading the clouds");
  std::optional<TruthRecord> truth;
  if (!files.truth.empty()) truth.emplace(files.truth);
  const auto job = make_job(*family, files, truth ? &*truth : nullptr);
  RunRecorder recorder;
  SearchVolume search;
  Warnings warnings;
  Observers observers;
  observers.add(recorder);
  observers.add(search);
  observers.add(warnings);
  if (options.observer != nullptr) observers.add(*options.observer);
  RunOptions watched = options;
  watched.observer = &observers;
  request.tell("making the surface");
  RecordedSurface recorded;
  const auto start = std::chrono::steady_clock::now();
  pipeline.in_run(watched, [&](const Context& context) { recorded.result = job(context); });
  recorded.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  recorded.covered = share_of_heights(recorded.result.fused.heights.values);
  if (recorded.covered == 0)
    recorded.failure = "the surface is empty: no pixel of any pair matched";
  request.tell("writing the results");
  folder.begin();
  write_outputs(recorded.result, folder);
  Json json = record_of(pipeline, request, inputs, recorded, options);
  json["peak_memory_bytes"] = peak_memory();
  json["search"] = {{"disparities_per_pixel", search.per_pixel()}, {"widest", search.widest()}};
  if (truth) {
    recorded.truth = truth->judge(recorded.result, warnings.all);
    json["truth"] = truth_json(recorded.truth);
  }
  json["stages"] = to_json(recorder.stages());
  json["warnings"] = warnings.all;
  json["outputs"] = to_json(folder.outputs());
  write_file(folder.file(kRecordFile), json.dump(2) + "\n");
  folder.end();
  return recorded;
}

}  // namespace xgm::geo
