// SPDX-License-Identifier: Apache-2.0
#include "plugin/binder.hpp"

#include <algorithm>

#include "config/fields.hpp"
#include "plugin/unknown_plugin.hpp"
#include "stage/misbehaviour.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm {
namespace {

std::string article(std::string_view kind) {
  const bool vowel = std::string_view("aeiou").find(kind.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(kind);
}

std::vector<std::string> names_of(const std::vector<const PluginInfo*>& plugins) {
  std::vector<std::string> names;
  for (const PluginInfo* plugin : plugins) names.push_back(plugin->name);
  return names;
}

Node bare_word(const std::string& word, const Location& where) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.where = where;
  node.scalar = word;
  return node;
}

}  // namespace

Binder::BoundStage Binder::stage(const Node& node, std::string_view kind) {
  const std::string what = article(kind);
  if (!node.is_scalar() && !node.is_map()) {
    diagnose(node.where, "expected " + what + ", found " + spell(node),
             "write a name or {type: NAME, ...}");
    return {};
  }
  const Entry* type = node.is_map() ? node.find("type") : nullptr;
  if (node.is_map() && (type == nullptr || !type->value.is_scalar())) {
    diagnose(type != nullptr ? type->value.where : node.where,
             "this " + std::string(kind) + " does not say which one it is",
             "add 'type: NAME', NAME being one of " + join(names_of(registry_.plugins(kind))));
    return {};
  }
  const Node& name = node.is_map() ? type->value : node;
  const PluginInfo* plugin = find_plugin(name, kind);
  if (plugin == nullptr) return {};

  Node none;
  none.kind = Node::Kind::map;
  none.where = node.where;
  BoundStage result{nullptr, plugin->name, {{"type", plugin->name}}};
  with_plugin(*plugin, name.where, [&] {
    const std::unique_ptr<Prototype> prototype = plugin->prototype();
    BoundFields bound =
        fields(node.is_map() ? node : none, prototype->parameters(), plugin->name, {"type"});
    result.resolved.update(bound.resolved);
    if (bound.good) result.stage = built(*prototype, kind, result.resolved);
  });
  return result;
}

std::shared_ptr<const Stage> Binder::built(Prototype& prototype, std::string_view kind,
                                           const Json& resolved) {
  if (kind != Matcher::kKind) return prototype.build();
  auto known = std::find_if(matchers_.begin(), matchers_.end(),
                            [&](const auto& matcher) { return matcher.first == resolved; });
  if (known == matchers_.end()) {
    known = matchers_.emplace(matchers_.end(), resolved, prototype.build());
  }
  bound_.push_back(known->second.get());
  return known->second;
}

Binder::BoundStage Binder::pipeline(const Node& root) {
  const Entry* type = root.find("type");
  const Node name =
      type != nullptr ? type->value : bare_word(std::string(PipelineFamily::kDefault), root.where);
  if (!name.is_scalar()) {
    diagnose(name.where, "'type' of a pipeline must be a name, not " + spell(name),
             "write one of " + join(names_of(registry_.plugins(PipelineFamily::kKind))));
    return {};
  }
  const PluginInfo* family = find_plugin(name, PipelineFamily::kKind);
  if (family == nullptr) return {};
  int version = 1;
  BoundStage result{nullptr, family->name, {{"xgm", version}}};
  if (type != nullptr) result.resolved["type"] = family->name;
  with_plugin(*family, name.where, [&] {
    const std::unique_ptr<Prototype> prototype = family->prototype();
    prototype->parameters().add("xgm", version, "Version of the file format.").range(1, 1);
    BoundFields bound = fields(root, prototype->parameters(), "a pipeline", {"type"});
    bound.resolved.erase("xgm");
    result.resolved.update(bound.resolved);
    if (bound.good) result.stage = prototype->build();
  });
  return result;
}

template <class Body>
void Binder::with_plugin(const PluginInfo& plugin, const Location& where, const Body& body) {
  try {
    try {
      body();
    } catch (...) {
      rethrow_as_error(place_of(plugin.kind, plugin.name));
    }
  } catch (const Error& error) {
    diagnose(where, error.message(), "");
  }
}

const PluginInfo* Binder::find_plugin(const Node& name, std::string_view kind) {
  if (const PluginInfo* plugin = registry_.find(kind, name.scalar)) return plugin;
  const auto others = registry_.named(name.scalar);
  if (!others.empty()) {
    diagnose(name.where,
             "'" + name.scalar + "' is " + article(others.front()->kind) + ", not " + article(kind),
             "put " + article(kind) + " here: " + join(names_of(registry_.plugins(kind))));
    return nullptr;
  }
  for (const LoadFailure& failure : registry_.failures()) {
    if (failure.name != name.scalar && !failure.provides.contains(name.scalar)) continue;
    diagnose(name.where, std::string(kind) + " " + quote(name.scalar) + " could not be loaded",
             failure.file + ": " + failure.reason);
    return nullptr;
  }
  diagnose(name.where, "there is no " + std::string(kind) + " called " + quote(name.scalar),
           unknown_remedy(name.scalar, kind));
  return nullptr;
}

std::string Binder::choices_of(std::string_view kind) const {
  if (kind == PipelineFamily::kKind) return "a shipped pipeline, or the file of one";
  return "one of " + join(names_of(registry_.plugins(kind)));
}

std::string Binder::unknown_remedy(const std::string& name, std::string_view kind) const {
  const std::vector<std::string> known = names_of(registry_.plugins(kind));
  std::string remedy =
      unknown_plugin_remedy(name, known, "known " + std::string(kind) + " plugins");
  if (!closest(name, known).empty()) return remedy;  // what is not loaded has nothing to do with it
  for (const LoadFailure& failure : registry_.failures()) {
    if (failure.named_all) continue;  // this one is not among them
    remedy += " (not loaded: " + failure.file + ": " + failure.reason + ")";
  }
  return remedy;
}

void Binder::check_keys(const Node& map, const ParameterSet& set, const std::string& owner,
                        const std::set<std::string>& skip) {
  std::vector<std::string> known;
  for (const Field& field : set.fields()) known.push_back(field.name);
  for (const Entry& entry : map.entries) {
    const Entry* first = map.find(entry.key);
    if (first != &entry) {
      diagnose(
          entry.where, "key " + quote(entry.key) + " appears twice",
          "keep one of them (the first stands in line " + std::to_string(first->where.line) + ")");
    } else if (!skip.contains(entry.key) &&
               std::find(known.begin(), known.end(), entry.key) == known.end()) {
      const bool is_number = entry.value.is_null() && to_number<double>(entry.key);
      const std::string remedy =
          known.empty() ? "it has none" : suggest(entry.key, known, "parameters");
      diagnose(
          entry.where, owner + " has no parameter " + quote(entry.key),
          is_number ? "the comma before it ends a value; write decimals with a point" : remedy);
    }
  }
}

Binder::BoundFields Binder::fields(const Node& map, ParameterSet& set, const std::string& owner,
                                   const std::set<std::string>& skip) {
  const std::size_t before = diagnostics_.size();
  check_keys(map, set, owner, skip);
  BoundFields result;
  result.resolved = Json::object();
  std::set<std::string> faulty;
  for (const Field& field : set.fields()) {
    if (!bind(field, map.find(field.name), map, owner, result.resolved[field.name])) {
      faulty.insert(field.name);
    }
  }
  for (const Rule& rule : set.rules()) {
    const auto is_faulty = [&](const std::string& name) { return faulty.contains(name); };
    if (std::any_of(rule.fields.begin(), rule.fields.end(), is_faulty) || rule.holds()) continue;
    const Entry* entry = nullptr;
    for (const std::string& name : rule.fields) {
      if (entry == nullptr) entry = map.find(name);
    }
    diagnose(entry != nullptr ? entry->value.where : map.where,
             "'" + rule.fields.front() + "' of " + owner + " " + rule.message, "");
  }
  result.good = diagnostics_.size() == before;
  return result;
}

bool Binder::bind(const Field& field, const Entry* entry, const Node& map, const std::string& owner,
                  Json& resolved) {
  const bool given = entry != nullptr && !entry->value.is_null();
  if (auto* const* slot = std::get_if<SlotBase*>(&field.target)) {
    if (given) return bind_slot(field, **slot, entry->value, field.name, resolved);
    if (!field.default_stage_name.empty()) {
      return bind_slot(field, **slot, bare_word(field.default_stage_name, map.where), field.name,
                       resolved);
    }
    if (field.is_optional) return true;
    diagnose(map.where, owner + " needs '" + field.name + "'",
             "add '" + field.name + ": NAME', NAME being " + choices_of(stage_kind(field)));
    return false;
  }
  if (is_stage_list(field)) {
    resolved = Json::array();
    return !given || bind_list(field, entry->value, resolved);
  }
  const bool good = entry == nullptr || bind_value(field, entry->value, diagnostics_);
  resolved = value_of(field);
  return good;
}

bool Binder::bind_slot(const Field& field, SlotBase& slot, const Node& node,
                       const std::string& place, Json& resolved) {
  const auto before = static_cast<std::ptrdiff_t>(bound_.size());
  BoundStage bound = stage(node, stage_kind(field));
  resolved = std::move(bound.resolved);
  return bound.stage != nullptr &&
         slot.assign(bound.stage, bound.plugin, place, {bound_.begin() + before, bound_.end()});
}

bool Binder::bind_list(const Field& field, const Node& node, Json& resolved) {
  if (!node.is_list()) {
    diagnose(node.where, "'" + field.name + "' must be " + expected(field) + ", not " + spell(node),
             "write it in brackets: [NAME, {type: NAME, ...}]");
    return false;
  }
  SlotListBase& slots = *std::get<SlotListBase*>(field.target);
  bool good = true;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    Json item;
    const std::string place = field.name + "[" + std::to_string(i) + "]";
    good &= bind_slot(field, slots.append(), node.items[i], place, item);
    resolved.push_back(std::move(item));
  }
  return good;
}

void Binder::diagnose(const Location& where, std::string message, std::string remedy) {
  add_diagnostic(diagnostics_, where, std::move(message), std::move(remedy));
}

}  // namespace xgm
