// SPDX-License-Identifier: Apache-2.0
#include "run/surface_question.hpp"

#include <map>

#include "ground/paths.hpp"
#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/question.hpp"

namespace xgm::geo {
namespace {

/// Whether what is matched depends on files of a role.
bool is_asked(const std::string& role) {
  const bool is_beside = role.starts_with("file of the ") && role != "file of the truth";
  return is_beside || role == "image" || role == "mask" || role == "camera" || role == "DEM" ||
         role == "area";
}

}  // namespace

Json question_of(const Pipeline& pipeline, const SurfaceFiles& files,
                 const std::vector<InputFile>& read, const std::vector<SatelliteImage>& images,
                 const SurfaceRecordRequest& request) {
  Json question = xgm::question_of(pipeline, request.keep->plugin_files);
  std::map<std::string, int> count;
  for (const InputFile& file : read) {
    if (!is_asked(file.role)) continue;
    const std::string name = file.role + " " + std::to_string(++count[file.role]);
    question[name] = file.identity.fnv1a64;
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    question["RPC of image " + std::to_string(i + 1)] =
        hash_text(rpc_text(images[i].camera.model()));
  }
  for (const std::string& dem : files.dem) question["datums of the DEM"].push_back(dem_datum(dem));
  if (!is_there(files.area)) question["--area"] = files.area;
  question["--band"] = files.band;
  question["--geoid"] = request.geoid;
  return question;
}

Json question_of_matching(const Json& question) {
  Json matching = {{"program", question.at("program")},
                   {"plugin files", question.at("plugin files")},
                   {"pipeline", question.at("pipeline").at("matching")}};
  return question_of_matcher(std::move(matching));
}

}  // namespace xgm::geo
