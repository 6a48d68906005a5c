// SPDX-License-Identifier: Apache-2.0
#include "pipeline/family_meant.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "xgm/stage/pipeline.hpp"

namespace xgm {
namespace {

std::set<std::string> keys_of(const PluginInfo& family) {
  std::set<std::string> keys;
  try {
    const std::unique_ptr<Prototype> prototype = family.prototype();
    for (const Field& field : prototype->parameters().fields()) keys.insert(field.name);
  } catch (...) {
    return {};  // no file is meant for it; the binder tells of the fault to who names it
  }
  return keys;
}

}  // namespace

void put_type(Node& root, std::string_view family) {
  Node type;
  type.kind = Node::Kind::scalar;
  type.where = root.where;
  type.scalar = family;
  root.entries.insert(root.entries.begin(), Entry{"type", root.where, std::move(type)});
}

void put_type_meant(Node& root, const Registry& registry, Diagnostics& diagnostics) {
  const PluginInfo* meant = registry.find(PipelineFamily::kKind, PipelineFamily::kDefault);
  if (meant == nullptr || root.find("type") != nullptr) return;
  const auto known_to = [&](const std::set<std::string>& keys) {
    return std::ranges::count_if(root.entries,
                                 [&](const Entry& e) { return keys.contains(e.key); });
  };
  const std::set<std::string> usual = keys_of(*meant);
  std::set<std::string> known = usual;
  for (const PluginInfo* family : registry.plugins(PipelineFamily::kKind)) {
    std::set<std::string> keys = keys_of(*family);
    if (known_to(keys) <= known_to(known)) continue;
    meant = family;
    known = std::move(keys);
  }
  // One that knows more keys knows one that the default family does not.
  const auto telling = std::ranges::find_if(root.entries, [&](const Entry& e) {
    return known.contains(e.key) && !usual.contains(e.key);
  });
  if (telling == root.entries.end()) return;
  add_diagnostic(diagnostics, telling->where,
                 quote(telling->key) + " is for pipelines of type " + meant->name +
                     ", and this file names no type",
                 "add 'type: " + meant->name + "' at its top");
  put_type(root, meant->name);
}

}  // namespace xgm
