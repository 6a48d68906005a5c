// SPDX-License-Identifier: Apache-2.0
#include "xgm/plugin/registry.hpp"

#include <algorithm>

#include "plugin/core_kinds.hpp"
#include "stage/misbehaviour.hpp"
#include "xgm/base/error.hpp"

namespace xgm {

namespace {

/// The same, but what describe() of the plugin throws is an Error that names the plugin.
std::function<std::unique_ptr<Prototype>()> guarded(const PluginInfo& info) {
  return [make = info.prototype, place = place_of(info.kind, info.name)] {
    try {
      return make();
    } catch (...) {
      rethrow_as_error(place);
    }
  };
}

}  // namespace

namespace builtin {
void add_core(Registry& registry);  // generated
}

Prototype::~Prototype() = default;

Registry::Registry() { add_core_kinds(*this); }

Registry Registry::with_builtins() {
  Registry registry;
  builtin::add_core(registry);
  return registry;
}

void Registry::add(KindInfo kind) {
  for (const KindInfo& known : kinds_) {
    if (known.name != kind.name) continue;
    if (known.meaning == kind.meaning) return;
    throw Error("there is already a kind of stage called '" + kind.name + "', which " +
                known.meaning + "; choose another name");
  }
  kinds_.push_back(std::move(kind));
}

void Registry::add(PluginInfo info) {
  if (!has_kind(info.kind)) {
    throw Error("'" + info.name + "' is of kind '" + info.kind +
                "', which is not known; call add_kind() first");
  }
  std::pair key(info.kind, info.name);
  const auto known = plugins_.find(key);
  if (known != plugins_.end()) {
    const std::string& origin = known->second.origin;
    throw Error("there is already a " + info.kind + " called '" + info.name + "' (" +
                (origin.empty() ? "built in" : origin) + "); choose another name");
  }
  info.prototype = guarded(info);
  plugins_.emplace(std::move(key), std::move(info));
}

bool Registry::remove(std::string_view kind, std::string_view name) {
  return plugins_.erase(std::pair(std::string(kind), std::string(name))) > 0;
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

bool Registry::has_kind(std::string_view kind) const {
  return std::any_of(kinds_.begin(), kinds_.end(),
                     [&](const KindInfo& known) { return known.name == kind; });
}

}  // namespace xgm
