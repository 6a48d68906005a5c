// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/file_names.hpp"

#include <algorithm>
#include <filesystem>

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// Also a link that leads nowhere has its name.
bool is_there(const fs::path& path) {
  std::error_code unusable;
  return fs::exists(fs::symlink_status(path, unusable));
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code unusable;
  const fs::path listed = folder.empty() ? "." : folder;
  for (fs::directory_iterator i(listed, unusable), end; !unusable && i != end;
       i.increment(unusable)) {
    names.insert(i->path().filename().string());
  }
  return names;
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::string find_name(const std::set<std::string>& names, const std::string& name) {
  if (names.contains(name)) return name;
  std::string found;
  for (const std::string& other : names) {
    if (lower_case(other) != lower_case(name)) continue;
    if (!found.empty()) return {};
    found = other;
  }
  return found;
}

std::string find_path(const std::string& path) {
  const fs::path wanted(path);
  if (is_there(wanted) || !wanted.has_filename()) return path;
  const fs::path folder(find_path(wanted.parent_path().string()));
  const std::string name = find_name(names_in(folder), wanted.filename().string());
  return name.empty() ? path : (folder / name).string();
}

}  // namespace xgm
