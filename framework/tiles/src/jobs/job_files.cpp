// SPDX-License-Identifier: Apache-2.0
#include "jobs/job_files.hpp"

#include <array>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/stored_map.hpp"

namespace xgm::tiles {
namespace {

namespace fs = std::filesystem;

std::string done_file(const JobManifest& manifest, const TileJob& job) {
  return (fs::path(jobs_folder(manifest)) / (job.name + ".json")).string();
}

std::string reverse_name(const TileJob& job) { return job.name + "_reverse"; }

bool is_as_written(const fs::path& folder, const Json& file) {
  const FileIdentity now = identify_file((folder / file.at("name").text()).string());
  return static_cast<double>(now.bytes) == file.at("bytes").number() &&
         now.fnv1a64 == file.at("fnv1a64").text();
}

Json record_of(const JobManifest& manifest, const TileJob& job) {
  return Json::parse(read_file(done_file(manifest, job)));
}

}  // namespace

std::string jobs_folder(const JobManifest& manifest) {
  return (fs::path(manifest.file).parent_path() / kJobsFolder).string();
}

std::string hash_text(std::string_view bytes) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx",
                static_cast<unsigned long long>(fnv1a64(bytes)));
  return text.data();
}

void write_result(const JobManifest& manifest, const TileJob& job, const MatchResult& result,
                  double seconds) {
  const fs::path folder = jobs_folder(manifest);
  make_output_folder(folder.string());
  fs::remove(done_file(manifest, job));  // what it says is not true from now on
  std::vector<std::string> names = write_stored_map(folder.string(), job.name, result.forward);
  if (result.reverse) {
    for (std::string& name :
         write_stored_map(folder.string(), reverse_name(job), *result.reverse)) {
      names.push_back(std::move(name));
    }
  }
  Json files = Json::array();
  for (const std::string& name : names) {
    const FileIdentity identity = identify_file((folder / name).string());
    files.push_back({{"name", name}, {"bytes", identity.bytes}, {"fnv1a64", identity.fnv1a64}});
  }
  const Json record = {{"job", job.name},           {"question", question_hash(manifest)},
                       {"files", std::move(files)}, {"has_reverse", result.reverse.has_value()},
                       {"seconds", seconds},        {"peak_memory_bytes", peak_memory()}};
  write_file(done_file(manifest, job), record.dump(2) + "\n");
}

MatchResult read_result(const JobManifest& manifest, const TileJob& job) {
  const std::string folder = jobs_folder(manifest);
  MatchResult result{read_stored_map(folder, job.name), std::nullopt};
  const Json record = record_of(manifest, job);
  if (record.at("has_reverse").dump() == "true") {
    result.reverse = read_stored_map(folder, reverse_name(job));
  }
  return result;
}

bool is_done(const JobManifest& manifest, const TileJob& job) {
  try {
    const Json record = record_of(manifest, job);
    if (record.at("question").text() != question_hash(manifest)) return false;
    for (const Json& file : record.at("files")) {
      if (!is_as_written(jobs_folder(manifest), file)) return false;
    }
    return true;
  } catch (const Error&) {  // missing, or cut off
    return false;
  }
}

}  // namespace xgm::tiles
