// SPDX-License-Identifier: Apache-2.0
#include "bench/identity.hpp"

#include <filesystem>
#include <opencv2/core/version.hpp>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/pipeline/installation.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr int kFormat = 1;

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
                {"program", identity_json(request.program)},
                {"opencv", CV_VERSION},
                {"pipeline", Json::parse(request.pipelines[pipeline].resolved)},
                {"images", identity_json(where.images)},
                {"threads", request.threads}};
  if (where.files.disparities) {
    identity["disparities"] = {where.files.disparities->begin, where.files.disparities->end};
  }
  return identity.dump();
}

std::vector<std::string> cell_files(const std::string& folder) {
  std::vector<std::string> files = job_files(folder);
  for (const char* name : kMapFiles) files.push_back((fs::path(folder) / name).string());
  files.push_back((fs::path(folder) / kConfidenceFile).string());
  return files;
}

}  // namespace xgm
