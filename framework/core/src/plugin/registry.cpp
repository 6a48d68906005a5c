// SPDX-License-Identifier: Apache-2.0
#include "xgm/plugin/registry.hpp"

#include "xgm/base/error.hpp"

namespace xgm {

namespace builtin {
void add_all(Registry& registry);  // generated
}

Prototype::~Prototype() = default;

Registry Registry::with_builtins() {
  Registry registry;
  builtin::add_all(registry);
  return registry;
}

void Registry::add(PluginInfo info) {
  std::pair key(info.kind, info.name);
  const auto known = plugins_.find(key);
  if (known != plugins_.end()) {
    const std::string& origin = known->second.origin;
    throw Error("there is already a " + info.kind + " called '" + info.name + "' (" +
                (origin.empty() ? "built in" : origin) + "); choose another name");
  }
  plugins_.emplace(std::move(key), std::move(info));
}

const PluginInfo* Registry::find(std::string_view kind, std::string_view name) const {
  const auto found = plugins_.find(std::pair(std::string(kind), std::string(name)));
  return found == plugins_.end() ? nullptr : &found->second;
}

std::vector<const PluginInfo*> Registry::plugins(std::string_view kind) const {
  std::vector<const PluginInfo*> found;
  for (const auto& [key, info] : plugins_) {
    if (kind.empty() || info.kind == kind) found.push_back(&info);
  }
  return found;
}

std::vector<const PluginInfo*> Registry::named(std::string_view name) const {
  std::vector<const PluginInfo*> found;
  for (const auto& [key, info] : plugins_) {
    if (info.name == name) found.push_back(&info);
  }
  return found;
}

const std::vector<std::pair<std::string, std::string>>& Registry::kinds() {
  static const std::vector<std::pair<std::string, std::string>> kKinds{
      {"dataset", "finds the scenes in a folder, and by which truth to judge them"},
      {"preprocess", "makes a better image pair of an image pair"},
      {"matcher", "finds the disparity maps of an image pair; matchers may hold matchers"},
      {"search_range", "narrows what the next finer level of a pyramid searches"},
      {"cost", "compares a base pixel with its candidates in the match image"},
      {"penalty", "weighs disparity steps between neighbours: P1 and P2"},
      {"aggregation", "sums the costs along paths through the image"},
      {"selection", "picks one disparity per pixel"},
      {"refinement", "moves a disparity by a fraction of a pixel"},
      {"filter", "makes a better disparity map of a disparity map"},
      {"consistency", "compares the maps of both views"},
  };
  return kKinds;
}

}  // namespace xgm
