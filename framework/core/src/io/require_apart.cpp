// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/require_apart.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <map>

#include "io/replaceable.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// The same for all paths and links to one file; for a file that is still to be made, its place.
std::string identity_of(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) {
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
  }
  std::error_code unusable;
  return fs::weakly_canonical(fs::absolute(file, unusable), unusable).string();
}

}  // namespace

void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  std::map<std::string, const NamedFile*> read, written;
  for (const NamedFile& input : inputs) {
    if (!input.file.empty()) read.emplace(identity_of(input.file), &input);
  }
  for (const NamedFile& output : outputs) {
    if (output.file.empty()) continue;
    const std::string identity = identity_of(output.file);
    const auto refuse = [&](const std::string& reason) {
      throw UsageError(output.role + ": " + output.file + " " + reason);
    };
    if (const auto lost = read.find(identity); lost != read.end()) {
      refuse("is an input, which would be lost (" + lost->second->role + ": " + lost->second->file +
             "); give another " + output.role);
    }
    const std::string objection = objection_to_replacing(output.file);
    if (!objection.empty()) refuse("cannot be written: " + objection);
    const auto [first, is_new] = written.emplace(identity, &output);
    if (!is_new) {
      refuse("is written for " + first->second->role + " (" + first->second->file +
             "), too; give another " + output.role);
    }
  }
}

}  // namespace xgm
