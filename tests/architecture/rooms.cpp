// SPDX-License-Identifier: Apache-2.0
#include "architecture/rooms.hpp"

#include <map>

namespace xgm::architecture {
namespace {

const std::map<std::string, std::set<std::string>>& rooms() {
  static const std::map<std::string, std::set<std::string>> below{
      {"core", {}},
      {"synthesis", {"core"}},
      {"tiles", {"core"}},
      {"evaluation", {"core"}},
      {"testing", {"core", "synthesis"}},
      {"geo", {"core", "evaluation", "synthesis"}},
  };
  return below;
}

const std::map<std::string, int>& core_layers() {
  static const std::map<std::string, int> layers{{"base", 0},     {"data", 1},    {"config", 1},
                                                 {"stage", 2},    {"plugin", 3},  {"io", 4},
                                                 {"exchange", 5}, {"pipeline", 6}};
  return layers;
}

/// "a" of {"a", "b.hpp"}; "b" of {"b.hpp"} if that is wanted, else "".
std::string first_folder(const std::vector<std::string>& parts, std::size_t at, bool of_header) {
  if (at + 1 < parts.size()) return parts[at];
  if (!of_header || at >= parts.size()) return {};
  return parts[at].substr(0, parts[at].find('.'));
}

}  // namespace

std::string room_of_header(const std::string& target) {
  const std::vector<std::string> parts = split_path(target);
  return parts.size() > 2 && parts[1] != "core" && rooms().contains(parts[1]) ? parts[1] : "core";
}

Place place_of(const std::string& file) {
  const std::vector<std::string> parts = split_path(file);
  if (parts.size() < 4) return {parts.size() > 1 ? parts[1] : "", "", false};
  const std::string& room = parts[1];
  if (parts[2] != "include") return {room, first_folder(parts, 3, false), false};
  return {room, first_folder(parts, room == "core" ? 4 : 5, room == "core"), true};
}

const std::set<std::string>* rooms_below(const std::string& room) {
  const auto found = rooms().find(room);
  return found == rooms().end() ? nullptr : &found->second;
}

bool is_core_folder(const std::string& folder) { return core_layers().contains(folder); }

bool core_folder_may_include(const std::string& from, const std::string& to) {
  if (!is_core_folder(from) || !is_core_folder(to)) return false;
  return from == to || core_layers().at(from) > core_layers().at(to);
}

}  // namespace xgm::architecture
