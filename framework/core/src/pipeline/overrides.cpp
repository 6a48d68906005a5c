// SPDX-License-Identifier: Apache-2.0
#include "pipeline/overrides.hpp"

#include <optional>

#include "xgm/base/scalar.hpp"

namespace xgm {
namespace {

constexpr std::size_t kMaxSteps = 100;  // as deep as a pipeline file may be

struct Step {
  std::string key;
  std::vector<std::size_t> indices;
};

// "a.b[0].c" to steps; nothing if malformed.
std::optional<std::vector<Step>> split(const std::string& path) {
  std::vector<Step> steps;
  std::size_t begin = 0;
  while (begin <= path.size()) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string part = path.substr(begin, end - begin);
    const std::size_t bracket = std::min(part.find('['), part.size());
    Step step{part.substr(0, bracket), {}};
    if (step.key.empty()) return std::nullopt;
    for (std::size_t i = bracket; i < part.size();) {
      const std::size_t close = part.find(']', i);
      if (part[i] != '[' || close == std::string::npos) return std::nullopt;
      const auto index = to_number<std::size_t>(part.substr(i + 1, close - i - 1));
      if (!index) return std::nullopt;
      step.indices.push_back(*index);
      i = close + 1;
    }
    if (steps.size() == kMaxSteps) return std::nullopt;
    steps.push_back(std::move(step));
    begin = end + 1;
  }
  return steps;
}

// {type: name} for a bare name, a map for nothing.
void become_map(Node& node) {
  if (node.is_scalar()) {
    Node name = node;
    node = Node{};
    node.where = name.where;
    node.entries.push_back({"type", name.where, std::move(name)});
  }
  node.kind = Node::Kind::map;
}

// The child of that key, made if it is not there; null with a reason if it cannot be.
Node* child(Node& node, const Step& step, const Location& where, std::string& reason) {
  if (node.is_list()) {
    reason = "a list stands before '" + step.key + "'; give the place in it, as in filters[0]";
    return nullptr;
  }
  become_map(node);
  Entry* entry = node.find(step.key);
  if (entry == nullptr) {
    node.entries.push_back({step.key, where, {}});
    entry = &node.entries.back();
    entry->value.where = where;
  }
  Node* target = &entry->value;
  for (const std::size_t index : step.indices) {
    if (!target->is_list() || index >= target->items.size()) {
      reason = "'" + step.key + "' has " + std::to_string(target->items.size()) +
               " elements (counted from 0), none at [" + std::to_string(index) + "]";
      return nullptr;
    }
    target = &target->items[index];
  }
  return target;
}

void relocate(Node& node, const Location& where) {
  node.where = where;
  for (Node& item : node.items) relocate(item, where);
  for (Entry& entry : node.entries) {
    entry.where = where;
    relocate(entry.value, where);
  }
}

}  // namespace

void apply_override(Node& root, const Override& change, Diagnostics& diagnostics) {
  const Location where{"--set " + change.path + "=" + change.value};
  const auto steps = split(change.path);
  if (!steps) {
    add_diagnostic(diagnostics, where, "not a path", "write it like matcher.filters[0].window=5");
    return;
  }
  std::optional<Node> value = read_yaml(change.value, where.file, diagnostics);
  if (!value) return;
  relocate(*value, where);
  Node* target = &root;
  std::string reason;
  for (const Step& step : *steps) {
    target = child(*target, step, where, reason);
    if (target == nullptr) {
      add_diagnostic(diagnostics, where, reason, "'pipeline graph' shows what is there");
      return;
    }
  }
  *target = std::move(*value);
}

}  // namespace xgm
