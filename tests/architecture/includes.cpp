// SPDX-License-Identifier: Apache-2.0
#include "architecture/includes.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <sstream>

#include "architecture/rooms.hpp"

namespace xgm::architecture {
namespace {

/// The folders in which the build looks for what a file includes.
std::vector<std::string> include_folders(const std::string& file) {
  const std::vector<std::string> parts = split_path(file);
  std::vector<std::string> folders{file.substr(0, file.rfind('/') + 1), ""};
  if (parts.size() > 1 && parts[0] == "framework")
    folders.push_back("framework/" + parts[1] + "/src/");
  if (parts.size() > 1 && parts[0] == "apps") folders.push_back("apps/" + parts[1] + "/");
  if (parts[0] == "tests")
    folders.insert(folders.end(), {"tests/", "framework/core/src/", "framework/evaluation/src/",
                                   "framework/geo/src/"});
  return folders;
}

}  // namespace

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  std::vector<Include> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, directive)) found.push_back({match[2], match[1] == "\""});
  }
  return found;
}

std::string public_header(const std::string& target) {
  if (!target.starts_with("xgm/")) return {};
  return "framework/" + room_of_header(target) + "/include/" + target;
}

std::string resolve(const std::string& file, const std::string& target, const Tree& tree) {
  std::vector<std::string> paths{public_header(target)};
  for (const std::string& folder : include_folders(file)) paths.push_back(folder + target);
  for (const std::string& path : paths) {
    const std::string normal = std::filesystem::path(path).lexically_normal().generic_string();
    if (tree.contains(normal)) return normal;
  }
  return {};
}

bool is_inner_library(const std::string& target) {
  static constexpr std::array kBeginnings{"yaml-cpp/", "spdlog/", "CLI/", "nlohmann/",
                                          "gdal",      "ogr_",    "cpl_", "proj.h"};
  return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                     [&](const char* beginning) { return target.starts_with(beginning); });
}

}  // namespace xgm::architecture
