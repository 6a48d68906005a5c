// SPDX-License-Identifier: Apache-2.0
#include "pipeline/result_folder.hpp"

#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/stored_result.hpp"

namespace xgm {

std::string ResultFolder::id(const std::string& name) const {
  return hash_text(question_ + "\n" + name);
}

std::optional<MatchResult> ResultFolder::find(const std::string& name) {
  const std::string stored = id(name);
  const std::filesystem::path record = std::filesystem::path(folder_) / (stored + ".json");
  const StoredState state = state_of_result(folder_, stored, stored);
  if (state == StoredState::missing) return std::nullopt;
  try {
    if (state == StoredState::complete) {
      MatchResult result = read_result(folder_, stored);
      found_.push_back(name);
      return result;
    }
  } catch (const Error&) {
  }
  std::error_code gone;
  if (!std::filesystem::exists(record, gone)) return std::nullopt;  // another run has removed it
  tell_(folder_ + ": what was kept of " + name + " is damaged, and is made again");
  std::filesystem::remove(record, gone);
  return std::nullopt;
}

void ResultFolder::write(const std::string& name, const MatchResult& result) const {
  write_result(folder_, id(name), id(name), result, {{"name", name}});
}

}  // namespace xgm
