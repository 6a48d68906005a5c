// SPDX-License-Identifier: Apache-2.0
#include "architecture/rooms.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

/// The standard library has neither folders nor endings; OpenCV's core types are part of the SDK.
bool may_be_shown(const Include& include) {
  if (include.quoted) return false;
  return include.target.find_first_of("/.") == std::string::npos ||
         include.target == "opencv2/core.hpp" || include.target.starts_with("opencv2/core/");
}

Complaint judge_folders(const Place& from, const Place& to) {
  for (const std::string& folder : {from.folder, to.folder})
    if (!is_core_folder(folder))
      return "the folder '" + folder + "' has no place in the order of core's folders";
  if (core_folder_may_include(from.folder, to.folder)) return {};
  return from.folder + " does not lie above " + to.folder;
}

Complaint judge_rooms(const Place& from, const Place& to) {
  if (from.room == to.room) return from.room == "core" ? judge_folders(from, to) : Complaint();
  const std::set<std::string>* below = rooms_below(from.room);
  if (below == nullptr) return "the room '" + from.room + "' has no line in the table of rooms";
  if (below->contains(to.room)) return {};
  return "the room " + from.room + " does not lie above " + to.room;
}

}  // namespace

Complaint judge_in_framework(const std::string& file, const Include& include, const Tree& tree) {
  const Place from = place_of(file);
  if (const std::string header = public_header(include.target); !header.empty())
    return judge_rooms(from, place_of(header));
  if (from.is_public) {
    if (may_be_shown(include)) return {};
    return include.quoted ? "a public header may include public headers only"
                          : "a public header shows a library that stays inside";
  }
  const std::string beside = "framework/" + from.room + "/src/" + include.target;
  if (tree.contains(beside)) return judge_rooms(from, place_of(beside));
  if (!include.quoted && resolve(file, include.target, tree).empty()) return {};
  return "a room includes public headers, and its own private ones by their path below src";
}

}  // namespace xgm::architecture
