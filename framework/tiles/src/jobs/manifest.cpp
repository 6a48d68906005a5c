// SPDX-License-Identifier: Apache-2.0
// A manifest as JSON.
#include <algorithm>
#include <limits>

#include "jobs/job_files.hpp"
#include "jobs/look_json.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/data/calibration_json.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/map_in_parts.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/plugin/version.hpp"
#include "xgm/tiles/jobs.hpp"

namespace xgm::tiles {
namespace {

constexpr int kFormat = 3;

Json to_json(const cv::Rect& rect) {
  return Json(std::vector<int>{rect.x, rect.y, rect.width, rect.height});
}
Json to_json(cv::Size size) { return Json(std::vector<int>{size.width, size.height}); }

int whole(const Json& value) { return static_cast<int>(value.number()); }

std::vector<int> numbers(const Json& list, std::size_t count) {
  std::vector<int> values;
  for (const Json& value : list) values.push_back(whole(value));
  if (values.size() != count)
    throw Error("a list of " + std::to_string(count) + " numbers is missing");
  return values;
}

cv::Size size_of(const Json& json) {
  const std::vector<int> sides = numbers(json, 2);
  return {sides[0], sides[1]};
}

template <class Value>
std::vector<Value> list_of(const Json& json, Value (*value)(const Json&)) {
  std::vector<Value> all;
  for (const Json& element : json) all.push_back(value(element));
  return all;
}

std::string text_of(const Json& json) { return json.text(); }
double number_of(const Json& json) { return json.number(); }

Json to_json(const PairFiles& images) {
  return {{"left", images.left},
          {"right", images.right},
          {"left_mask", images.left_mask},
          {"right_mask", images.right_mask},
          {"no_data", Json(images.no_data)}};
}

PairFiles images_of(const Json& json) {
  return {.left = json.at("left").text(),
          .right = json.at("right").text(),
          .left_mask = json.at("left_mask").text(),
          .right_mask = json.at("right_mask").text(),
          .no_data = list_of(json.at("no_data"), number_of)};
}

Json to_json(const InputFile& input) {
  return {{"role", input.role},
          {"file", input.file},
          {"bytes", input.identity.bytes},
          {"fnv1a64", input.identity.fnv1a64}};
}

Json with_times(const std::vector<InputFile>& inputs) {
  Json list = Json::array();
  for (const InputFile& input : inputs) {
    Json json = to_json(input);
    json["modified_ns"] = input.identity.modified;
    list.push_back(std::move(json));
  }
  return list;
}

std::int64_t integer(const Json& json) {
  return std::visit([](auto value) { return static_cast<std::int64_t>(value); }, json.plain());
}

RunFacts facts_of(const Json& scene, const Json& calibration) {
  RunFacts facts{.scene = scene.text()};
  if (!calibration.is_null()) facts.calibration = calibration_of(calibration);
  return facts;
}

InputFile input_of(const Json& json) {
  return {.role = json.at("role").text(),
          .file = json.at("file").text(),
          .identity = {.bytes = static_cast<std::uint64_t>(integer(json.at("bytes"))),
                       .fnv1a64 = json.at("fnv1a64").text(),
                       .modified = integer(json.at("modified_ns"))}};
}

Json to_json(const TileJob& job) {
  Json json = {{"name", job.name}, {"needs", Json(job.needs)}};
  if (!job.place.empty()) json["place"] = to_json(job.place);
  json["memory_bytes"] = job.memory_bytes;
  json["seconds"] = job.seconds;
  json["result"] = std::string(kJobsFolder) + "/" + job.name + ".json";
  return json;
}

TileJob job_of(const Json& json) {
  TileJob job{.name = json.at("name").text(),
              .needs = list_of(json.at("needs"), text_of),
              .memory_bytes = json.at("memory_bytes").number(),
              .seconds = json.at("seconds").number()};
  if (const Json* place = json.find("place")) {
    const std::vector<int> sides = numbers(*place, 4);
    job.place = {sides[0], sides[1], sides[2], sides[3]};
  }
  return job;
}

/// Of the process that joins the jobs: itself, pictures of the map, and one tile.
double join_bytes(const JobManifest& manifest) {
  constexpr double kProcess = 150e6, kMapBytes = 5;
  const double all = std::numeric_limits<double>::infinity();
  return kProcess + MapInParts::held_bytes(manifest.size, all) +
         MapInParts::finish_bytes(manifest.size, all) + kMapBytes * manifest.tiles.size.area();
}

/// What decides of the results. When images were modified does not.
Json question(const JobManifest& manifest) {
  Json inputs = Json::array();
  for (const InputFile& input : manifest.inputs) inputs.push_back(to_json(input));
  const RunFacts& facts = manifest.facts;
  return {{"format", kFormat},
          {"xgm", XGM_VERSION},
          {"pipeline", Json::parse(manifest.pipeline)},
          {"plugins", Json(manifest.plugins)},
          {"scene", facts.scene},
          {"calibration", facts.calibration ? xgm::to_json(*facts.calibration) : Json()},
          {"images", to_json(manifest.images)},
          {"found_in_images", tiles::to_json(manifest.look)},
          {"inputs", std::move(inputs)},
          {"size", to_json(manifest.size)},
          {"disparities",
           Json(std::vector<int>{manifest.disparities.begin, manifest.disparities.end - 1})},
          {"tile_size", to_json(manifest.tiles.size)},
          {"halo", manifest.tiles.halo},
          {"coarse_pixels", manifest.tiles.coarse_pixels}};
}

JobManifest manifest_of(const Json& json) {
  if (whole(json.at("format")) != kFormat) throw Error("it is of another version of xgm");
  const std::vector<int> disparities = numbers(json.at("disparities"), 2);
  return {.pipeline_file = json.at("pipeline_file").text(),
          .pipeline = json.at("pipeline").dump(),
          .plugins = list_of(json.at("plugins"), text_of),
          .facts = facts_of(json.at("scene"), json.at("calibration")),
          .images = images_of(json.at("images")),
          .look = look_of(json.at("found_in_images")),
          .inputs = list_of(json.at("inputs"), input_of),
          .size = size_of(json.at("size")),
          .disparities = {disparities[0], disparities[1] + 1},
          .tiles = {.size = size_of(json.at("tile_size")),
                    .halo = whole(json.at("halo")),
                    .coarse_pixels = json.at("coarse_pixels").number()},
          .threads = whole(json.at("threads")),
          .jobs = list_of(json.at("jobs"), job_of)};
}

}  // namespace

std::string question_hash(const JobManifest& manifest) {
  return hash_text(question(manifest).dump());
}

void write_manifest(const JobManifest& manifest) {
  Json json = question(manifest);
  json["inputs"] = with_times(manifest.inputs);
  json["pipeline_file"] = manifest.pipeline_file;
  json["threads"] = manifest.threads;
  Json jobs = Json::array();
  for (const TileJob& job : manifest.jobs) jobs.push_back(to_json(job));
  json["jobs"] = std::move(jobs);
  json["join_memory_bytes"] = join_bytes(manifest);
  make_output_folder(jobs_folder(manifest));
  write_file(manifest.file, json.dump(2) + "\n");
}

JobManifest read_manifest(const std::string& file) {
  try {
    JobManifest manifest = manifest_of(Json::parse(read_file(file)));
    manifest.file = file;
    return manifest;
  } catch (const Error& error) {
    throw UsageError(file + ": is no manifest of jobs: " + error.message() +
                     "; make one with pipeline tiles plan");
  }
}

const TileJob& find_job(const JobManifest& manifest, const std::string& name) {
  const auto found = std::find_if(manifest.jobs.begin(), manifest.jobs.end(),
                                  [&](const TileJob& job) { return job.name == name; });
  if (found != manifest.jobs.end()) return *found;
  std::vector<std::string> names;
  for (const TileJob& job : manifest.jobs) names.push_back(job.name);
  require_name("job", name, names);
  throw UsageError("there is no job '" + name + "'");
}

}  // namespace xgm::tiles
