// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "architecture/rooms.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

/// What applications handle: data, files, pipelines, what is made of runs, and generated scenes.
bool is_open(const std::string& header) {
  static const std::set<std::string> rooms{"evaluation", "geo", "synthesis", "tiles"};
  static const std::set<std::string> core_folders{"base", "data", "io", "pipeline"};
  static const std::set<std::string> single{
      "xgm/config/diagnostics.hpp",  "xgm/plugin/registry.hpp", "xgm/plugin/version.hpp",
      "xgm/stage/context.hpp",       "xgm/stage/observers.hpp", "xgm/testing/new_plugin.hpp",
      "xgm/testing/plugin_check.hpp"};
  const Place place = place_of(public_header(header));
  if (single.contains(header)) return true;
  if (place.room != "core") return rooms.contains(place.room);
  return core_folders.contains(place.folder);
}

/// Stages that are written in Python are made there: what plugins include is for it, too.
bool makes_stages(const std::string& file, const std::string& header) {
  static const std::set<std::string> folders{"config", "plugin", "stage"};
  const Place place = place_of(public_header(header));
  return file.starts_with("apps/python/") && place.room == "core" && folders.contains(place.folder);
}

}  // namespace

Complaint judge_in_apps(const std::string& file, const Include& include, const Tree& tree) {
  if (include.target.starts_with("xgm/")) {
    if (is_open(include.target) || makes_stages(file, include.target)) return {};
    return "an application does not make, bind or test stages: this header is not for it";
  }
  const std::string top = "apps/" + split_path(file)[1] + "/";
  const std::string meant = resolve(file, include.target, tree);
  if (meant.empty() ? !include.quoted : meant.starts_with(top)) return {};
  return "an application may include the public headers of the rooms and its own files only";
}

}  // namespace xgm::architecture
