// SPDX-License-Identifier: Apache-2.0
#include "bench/identity.hpp"

#include <filesystem>
#include <opencv2/core/version.hpp>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/pipeline/installation.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr int kFormat = 1;

std::string in(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

Json json(const FileIdentity& identity) {
  return {{"bytes", identity.bytes}, {"fnv1a64", identity.fnv1a64}};
}

Json json(const std::vector<FileIdentity>& identities) {
  Json list = Json::array();
  for (const FileIdentity& identity : identities) list.push_back(json(identity));
  return list;
}

/// What a bench reads of a run.
Json results(const std::string& folder) {
  return {{"run.json", json(identify_file(in(folder, "run.json")))},
          {"disparity.pfm", json(identify_file(in(folder, "disparity.pfm")))}};
}

}  // namespace

std::vector<FileIdentity> identify_program(const std::string& program,
                                           const std::vector<std::string>& plugins) {
  // This library keeps the run's record, the core makes its map.
  const std::string recorder = file_of(reinterpret_cast<const void*>(&cell_identity));
  std::vector<FileIdentity> identities;
  for (const std::string& file : {program, library_file(), recorder}) {
    identities.push_back(identify_file(file));
  }
  for (const std::string& plugin : plugins) identities.push_back(identify_file(plugin));
  return identities;
}

void identify_images(std::vector<BenchScene>& scenes) {
  for (BenchScene& scene : scenes) {
    const PairFiles& files = scene.files.images;
    scene.images.clear();
    for (const std::string& file : {files.left, files.right, files.left_mask, files.right_mask}) {
      // What is missing fails when it is run, and stops no other scene.
      const bool is_there = !file.empty() && why_unreadable(file).empty();
      scene.images.push_back(is_there ? identify_file(file) : FileIdentity{});
    }
  }
}

std::string cell_identity(const BenchRequest& request, std::size_t pipeline, std::size_t scene) {
  const BenchScene& where = request.scenes[scene];
  Json identity{{"format", kFormat},
                {"program", json(request.program)},
                {"opencv", CV_VERSION},
                {"pipeline", Json::parse(request.pipelines[pipeline].resolved)},
                {"images", json(where.images)},
                {"threads", request.threads}};
  if (where.files.disparities) {
    identity["disparities"] = {where.files.disparities->begin, where.files.disparities->end};
  }
  return identity.dump();
}

bool is_done(const std::string& folder, const std::string& identity) {
  try {
    const Json mark = Json::parse(read_file(in(folder, "cell.json")));
    return mark.at("identity").dump() == identity &&
           mark.at("results").dump() == results(folder).dump();
  } catch (const std::exception&) {
    return false;  // missing, or cut short: run it again
  }
}

void begin_cell(const std::string& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw Error(folder + ": cannot be made: " + failure.message());
  for (const char* name : {"cell.json", "run.json"}) fs::remove(in(folder, name), failure);
}

void mark_done(const std::string& folder, const std::string& identity) {
  const Json mark{{"identity", Json::parse(identity)}, {"results", results(folder)}};
  write_file(in(folder, "cell.json"), mark.dump(2) + "\n");
}

}  // namespace xgm
