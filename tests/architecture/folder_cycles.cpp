// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "architecture/cycles.hpp"
#include "architecture/rooms.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

/// The names of the folders in a room's src.
std::set<std::string> private_folders(const std::string& room, const Tree& tree) {
  const std::string top = "framework/" + room + "/src/";
  std::set<std::string> folders;
  for (auto file = tree.lower_bound(top); file != tree.end() && file->first.starts_with(top);
       ++file)
    if (const std::string folder = place_of(file->first).folder; !folder.empty())
      folders.insert(folder);
  return folders;
}

/// The folder that implements a header that lies in no folder: the one with a source of the
/// header's name, else the one whose name is a word of it ("bench" of bench_tables.hpp), else a
/// folder of its own.
std::string implementing_folder(const std::string& room, const std::string& stem,
                                const Tree& tree) {
  const std::set<std::string> folders = private_folders(room, tree);
  if (folders.empty()) return {};
  for (const std::string& folder : folders)
    if (tree.contains("framework/" + room + "/src/" + folder + "/" + stem + ".cpp")) return folder;
  for (const std::string& folder : folders)
    if (("_" + stem + "_").find("_" + folder + "_") != std::string::npos) return folder;
  return stem;
}

std::string framework_folder(const std::string& file, const Tree& tree) {
  Place place = place_of(file);
  if (place.is_public && place.folder.empty()) {
    const std::string name = split_path(file).back();
    place.folder = implementing_folder(place.room, name.substr(0, name.find('.')), tree);
  }
  return "framework/" + place.room + (place.folder.empty() ? "" : "/" + place.folder);
}

/// The node that a file belongs to; "" for files that may include whatever they like.
std::string folder_of(const std::string& file, const Tree& tree) {
  const std::vector<std::string> parts = split_path(file);
  if (parts[0] == "framework") return framework_folder(file, tree);
  if (parts[0] != "plugins" && parts[0] != "apps") return {};
  const std::size_t depth = std::min<std::size_t>(3, parts.size() - 1);
  std::string folder = parts[0];
  for (std::size_t i = 1; i < depth; ++i) folder += "/" + parts[i];
  return folder;
}

Graph folder_graph(const Tree& tree) {
  Graph graph;
  for (const auto& [file, text] : tree) {
    const std::string from = folder_of(file, tree);
    if (from.empty()) continue;
    for (const Include& include : includes_of(text)) {
      const std::string target = resolve(file, include.target, tree);
      if (target.empty()) continue;
      const std::string to = folder_of(target, tree);
      if (!to.empty() && to != from) graph[from][to] = file + " includes " + include.target;
    }
  }
  return graph;
}

}  // namespace

Violations folder_cycles(const Tree& tree) {
  const Graph graph = folder_graph(tree);
  Violations violations;
  for (const Cycle& cycle : find_cycles(graph)) {
    std::string chain = "folder cycle:";
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::string& next = cycle[(i + 1) % cycle.size()];
      chain += "\n  " + cycle[i] + " -> " + next + ": " + graph.at(cycle[i]).at(next);
    }
    violations.push_back(chain);
  }
  return violations;
}

}  // namespace xgm::architecture
