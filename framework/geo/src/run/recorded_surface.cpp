// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/run/recorded_surface.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "run/search_volume.hpp"
#include "run/surface_outputs.hpp"
#include "run/surface_question.hpp"
#include "run/surface_report.hpp"
#include "run/truth_record.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/geo/ground/vertical_datum.hpp"
#include "xgm/io/file.hpp"
#include "xgm/stage/observers.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;

std::vector<NamedFile> files_read(const Pipeline& pipeline, const SurfaceFiles& files,
                                  const SurfaceRecordRequest& request) {
  std::vector<NamedFile> read = files_of(files);
  read.insert(read.begin(), {"pipeline", pipeline.file()});
  read.insert(read.end(), request.inputs.begin(), request.inputs.end());
  return read;
}

std::vector<NamedFile> files_written(const SurfaceFiles& files,
                                     const SurfaceRecordRequest& request) {
  std::vector<NamedFile> written;
  const auto add = [&](const std::string& name) {
    written.push_back({"--output", (fs::path(request.folder) / name).string()});
  };
  for (const std::string& name : output_names(files)) add(name);
  if (request.report) add(kReportFile);
  add(kRecordFile);
  return written;
}

/// GDAL takes NAME_rpc.txt beside an image for the camera of it, before what the image holds.
void require_no_cameras_beside(const std::vector<std::string>& images, const std::string& folder) {
  for (const std::string& image : images) {
    std::error_code unknown;
    const fs::path here = fs::absolute(image).parent_path();
    if (folder.empty() || !fs::equivalent(here, folder, unknown)) continue;
    throw UsageError("--output " + folder + ": the camera of " + image +
                     " that is written there would be taken for the image's own by later runs; "
                     "give another folder");
  }
}

CloudRequest read_cloud_request(const SurfaceFiles& files) {
  if (!files.images.empty() || !files.masks.empty() || !files.dem.empty() ||
      !files.cameras.empty() || files.band != 0) {
    throw UsageError("--clouds: clouds are made a surface of without images, masks and DEM");
  }
  const WantedArea area = parse_area(files.area);
  if (!area.window.empty()) {
    throw UsageError("area " + files.area +
                     ": clouds have no pixels; give WEST,SOUTH,EAST,NORTH in degrees, or a file");
  }
  return {read_clouds(files.clouds), area.box, area.outline};
}

using Job = std::function<SurfaceResult(const Context&)>;

/// The surface, of images or, if there are none, of clouds. `truth`, unless null, is told of all
/// that is matched.
Job make_job(const SurfaceFamily& family, const SurfaceFiles& files,
             std::optional<SurfaceRequest> images, TruthRecord* truth) {
  if (images) {
    if (truth != nullptr) {
      images->matched = [truth](const auto&... window) { truth->add(window...); };
    }
    return [&family, request = std::move(*images)](const Context& context) {
      return family.run(request, context);
    };
  }
  // Shared, since the clouds are large and a function must be able to be copied.
  const auto request = std::make_shared<CloudRequest>(read_cloud_request(files));
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
               const std::vector<InputFile>& inputs, const RecordedSurface& recorded,
               const RunOptions& options) {
  Json json;
  json["format"] = 1;
  json["versions"] = versions_json();
  json["command_line"] = request.command_line;
  json["pipeline"] = {{"file", pipeline.file()},
                      {"overrides", to_json(request.overrides)},
                      {"resolved", Json::parse(pipeline.resolved_json())}};
  json["scene"] = {{"inputs", to_json(inputs)}};
  json["grid"] = grid_json(recorded.result.grid, recorded.result.fused.heights);
  json["images"] = images_json(recorded.result);
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
    if (level != LogLevel::warning) return;
    all.push_back(place.path.empty() ? text : place.path + ": " + text);
  }
  std::vector<std::string> all;
};

void check_keeping(const SurfaceFiles& files, const SurfaceRecordRequest& request) {
  const std::string option = request.keep ? request.keep->option() : "";
  if (option.empty() || files.clouds.empty()) return;
  throw UsageError(option +
                   "clouds are made a surface of without matching, and nothing of that is kept; "
                   "leave it out");
}

/// Of what is matched of images.
Keeping keep_windows(const Pipeline& pipeline, const SurfaceFiles& files,
                     const std::vector<InputFile>& read, const std::vector<SatelliteImage>& images,
                     const SurfaceRecordRequest& request, Observer* observer) {
  const Json question = question_of(pipeline, files, read, images, request);
  return {*request.keep, request.folder, question, question_of_matching(question), observer};
}

/// The record last: it tells that all is there.
void finish(RunFolder& folder, const SurfaceRecordRequest& request, RecordedSurface& recorded,
            Json json) {
  if (request.report) {
    const std::string title = "Surface " + fs::absolute(request.folder).filename().string();
    write_file(folder.file(kReportFile), surface_report(title, recorded));
  }
  json["outputs"] = to_json(folder.outputs());
  recorded.record = json.dump(2) + "\n";
  write_file(folder.file(kRecordFile), recorded.record);
  folder.end();
}

double share_of_heights(const cv::Mat1f& heights) {
  const auto count =
      std::count_if(heights.begin(), heights.end(), [](float h) { return !std::isnan(h); });
  return static_cast<double>(count) / static_cast<double>(heights.total());
}

/// All who watch the run for its record.
struct Watchers {
  explicit Watchers(Observer* callers) {
    all.add(recorder);
    all.add(search);
    all.add(warnings);
    if (callers != nullptr) all.add(*callers);
  }

  RunRecorder recorder;
  SearchVolume search;
  Warnings warnings;
  Observers all;
};

RecordedSurface make_surface(const Pipeline& pipeline, const Job& job,
                             const SurfaceRecordRequest& request, const RunOptions& options) {
  request.tell("making the surface");
  RecordedSurface recorded;
  const auto start = std::chrono::steady_clock::now();
  pipeline.in_run(options, [&](const Context& context) { recorded.result = job(context); });
  recorded.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Raster& heights = recorded.result.fused.heights;
  if (!request.geoid.empty()) heights = above_geoid(heights, request.geoid);
  recorded.covered = share_of_heights(heights.values);
  if (recorded.covered == 0)
    recorded.failure = "the surface is empty: no pixel of any pair matched";
  return recorded;
}

}  // namespace

RecordedSurface record_surface(const Pipeline& pipeline, const SurfaceFiles& files,
                               const SurfaceRecordRequest& request, const RunOptions& options) {
  const auto* const family = dynamic_cast<const SurfaceFamily*>(&pipeline.family());
  if (family == nullptr) throw UsageError(pipeline.file() + ": is no pipeline of type surface");
  if (!request.geoid.empty()) require_geoid(request.geoid);
  check_keeping(files, request);
  require_no_cameras_beside(files.images, request.folder);
  const std::vector<NamedFile> inputs = files_read(pipeline, files, request);
  request.tell(files.clouds.empty() ? "reading the images" : "reading the clouds");
  std::optional<TruthRecord> truth;
  if (!files.truth.empty()) truth.emplace(files.truth);
  std::optional<SurfaceRequest> images;
  if (files.clouds.empty()) images = read_surface_request(files);
  const Job job = make_job(*family, files, images, truth ? &*truth : nullptr);
  std::optional<RunFolder> folder;
  if (!request.folder.empty()) {
    folder.emplace(request.folder, files_written(files, request), inputs, optional_names());
  }
  Watchers watchers(options.observer);
  const std::vector<InputFile> identified = identify_files(inputs);
  Keeping keeping;
  if (request.keep && images && folder) {
    keeping = keep_windows(pipeline, files, identified, images->images, request, &watchers.all);
  }
  RunOptions watched = options;
  watched.observer = &watchers.all;
  watched.kept = keeping.results();
  RecordedSurface recorded = make_surface(pipeline, job, request, watched);
  recorded.reused = keeping.reused();
  recorded.reused_from = keeping.folder();
  if (folder) {
    request.tell("writing the results");
    folder->begin();
    write_outputs(recorded.result, *folder);
  }
  Json json = record_of(pipeline, request, identified, recorded, options);
  json["peak_memory_bytes"] = peak_memory();
  json["search"] = {{"disparities_per_pixel", watchers.search.per_pixel()},
                    {"widest", watchers.search.widest()}};
  if (truth) {
    recorded.truth = truth->judge(recorded.result, watchers.all);
    json["truth"] = truth_json(recorded.truth);
  }
  json["stages"] = to_json(watchers.recorder.stages());
  if (!recorded.reused.empty()) json["reused"] = reused_json(recorded.reused_from, recorded.reused);
  json["warnings"] = watchers.warnings.all;
  recorded.record = json.dump(2) + "\n";
  recorded.warnings = std::move(watchers.warnings.all);
  if (folder) finish(*folder, request, recorded, std::move(json));
  keeping.end();
  return recorded;
}

}  // namespace xgm::geo
