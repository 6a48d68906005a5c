// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/stored_result.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/stored_map.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

std::string record_file(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / (name + ".json")).string();
}

std::string reverse_name(const std::string& name) { return name + "_reverse"; }

Json record_of(const std::string& folder, const std::string& name) {
  return Json::parse(read_file(record_file(folder, name)));
}

bool is_as_written(const fs::path& folder, const Json& file) {
  const FileIdentity now = identify_file((folder / file.at("name").text()).string());
  return static_cast<double>(now.bytes) == file.at("bytes").number() &&
         now.fnv1a64 == file.at("fnv1a64").text();
}

}  // namespace

StoredState state_of_result(const std::string& folder, const std::string& name,
                            const std::string& question) {
  std::error_code unusable;
  if (!fs::exists(record_file(folder, name), unusable)) return StoredState::missing;
  try {
    const Json record = record_of(folder, name);
    if (record.at("question").text() != question) return StoredState::missing;
    for (const Json& file : record.at("files")) {
      if (!is_as_written(folder, file)) return StoredState::damaged;
    }
    return StoredState::complete;
  } catch (const Error&) {  // cut off, or a file of it is missing
    return StoredState::damaged;
  }
}

void write_result(const std::string& folder, const std::string& name, const std::string& question,
                  const MatchResult& result, const Json& more) {
  std::error_code absent;
  fs::remove(record_file(folder, name), absent);  // what it says is not true from now on
  std::vector<std::string> names = write_stored_map(folder, name, result.forward);
  if (result.reverse) {
    for (std::string& file : write_stored_map(folder, reverse_name(name), *result.reverse)) {
      names.push_back(std::move(file));
    }
  }
  Json facts = {{"has_reverse", result.reverse.has_value()}};
  facts.update(more);
  write_record(folder, name, question, names, facts);
}

void write_record(const std::string& folder, const std::string& name, const std::string& question,
                  const std::vector<std::string>& files, const Json& more) {
  Json listed = Json::array();
  for (const std::string& written : files) {
    const std::string file = (fs::path(folder) / written).string();
    sync_file(file);
    const FileIdentity identity = identify_file(file);
    listed.push_back({{"name", written}, {"bytes", identity.bytes}, {"fnv1a64", identity.fnv1a64}});
  }
  Json record = {{"question", question}, {"files", std::move(listed)}};
  record.update(more);
  write_file(record_file(folder, name), record.dump(2) + "\n");
  sync_file(record_file(folder, name));
}

MatchResult read_result(const std::string& folder, const std::string& name) {
  MatchResult result{read_stored_map(folder, name), std::nullopt};
  const Json record = record_of(folder, name);
  if (record.at("has_reverse").dump() == "true") {
    result.reverse = read_stored_map(folder, reverse_name(name));
  }
  return result;
}

}  // namespace xgm
