// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "architecture/rooms.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

/// plugins/<kind>/<folder> of a file below it.
struct PluginFolder {
  std::string kind, name, path;
};

PluginFolder plugin_folder(const std::string& file) {
  const std::vector<std::string> parts = split_path(file);
  if (parts.size() < 4) return {};
  return {parts[1], parts[2], parts[0] + "/" + parts[1] + "/" + parts[2]};
}

/// Whether the folder holds no plugin but an engine that several plugins of its kind share.
bool is_engine(const PluginFolder& folder, const Tree& tree) {
  return has_folder(tree, folder.path) && !tree.contains(folder.path + "/" + folder.name + ".cpp");
}

/// Whether the plugin belongs to the room geo, which has kinds of its own.
bool is_of_geo(const PluginFolder& folder) {
  static const std::set<std::string> kinds{
      "fusion", "pairs", "pointing", "range_prior", "rectification", "surface", "triangulation"};
  return kinds.contains(folder.kind) || folder.path == "plugins/pipeline/surface";
}

/// Whether the plugin reads and writes files, in place of computing: what `exchange` is for.
bool is_of_exchange(const PluginFolder& folder) {
  return folder.name == "external" || folder.name == "precomputed";
}

Complaint judge_plugin_header(const PluginFolder& from, const std::string& target,
                              const Tree& tree) {
  const PluginFolder to = plugin_folder(target);
  if (to.path == from.path) return {};
  if (to.kind != from.kind) return "a plugin may not include what belongs to another kind";
  if (is_engine(to, tree)) return {};
  return "a plugin may not include another plugin";
}

}  // namespace

Complaint judge_in_plugins(const std::string& file, const Include& include, const Tree& tree) {
  if (is_inner_library(include.target)) return "a plugin uses a library that stays inside";
  if (include.target.starts_with("plugins/"))
    return judge_plugin_header(plugin_folder(file), include.target, tree);
  if (const std::string header = public_header(include.target); !header.empty()) {
    const Place place = place_of(header);
    if (place.room == "core" && core_folder_may_include("plugin", place.folder)) return {};
    if (place.folder == "exchange" && is_of_exchange(plugin_folder(file))) return {};
    if (place.room == "geo" && is_of_geo(plugin_folder(file))) {
      return place.folder == "run" ? "a plugin does not run pipelines" : Complaint();
    }
    return "this header is for programs, not for plugins";
  }
  if (!include.quoted) return {};
  return "a plugin may include the SDK and its own files by full path only";
}

}  // namespace xgm::architecture
