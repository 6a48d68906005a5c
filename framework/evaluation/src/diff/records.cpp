// SPDX-License-Identifier: Apache-2.0
#include "diff/records.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace xgm {
namespace {

/// Names and values, in the order of a record.
using Values = std::vector<std::pair<std::string, std::string>>;

std::string plain_text(const Json& value) {
  return value.is_string() ? value.text() : value.dump();
}

/// Every plain value below `json`: {"a": [{"b": 1}]} is "a[0].b" = "1".
void flatten(const Json& json, const std::string& path, Values& values) {
  if (json.is_object()) {
    for (const auto& [key, member] : json.members()) {
      flatten(member, path.empty() ? key : path + "." + key, values);
    }
  } else if (json.is_array()) {
    std::size_t i = 0;
    for (const Json& element : json)
      flatten(element, path + "[" + std::to_string(i++) + "]", values);
  } else if (!json.is_null()) {
    values.emplace_back(path, plain_text(json));
  }
}

/// The part of a record that the keys lead to; null if there is none.
const Json* part(const Json& record, std::initializer_list<const char*> keys) {
  const Json* at = &record;
  for (const char* key : keys) {
    if (at != nullptr) at = at->is_object() ? at->find(key) : nullptr;
  }
  return at;
}

Values values_of(const Json& record, std::initializer_list<const char*> keys,
                 const std::string& name = {}) {
  Values values;
  if (const Json* json = part(record, keys)) flatten(*json, name, values);
  return values;
}

/// What differs, in the order of the first; what only the second has comes last.
std::vector<Difference> compare(const Values& first, const Values& second) {
  std::vector<Difference> differences;
  const std::map<std::string, std::string> in_first(first.begin(), first.end());
  const std::map<std::string, std::string> in_second(second.begin(), second.end());
  for (const auto& [name, value] : first) {
    const auto other = in_second.find(name);
    const std::string text = other == in_second.end() ? kNoFigure : other->second;
    if (text != value) differences.push_back({name, value, text});
  }
  for (const auto& [name, value] : second) {
    if (!in_first.contains(name)) differences.push_back({name, kNoFigure, value});
  }
  return differences;
}

Values joined(Values first, const Values& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct Input {
  std::string content, text;
};

/// By role; several of one role are counted.
std::vector<std::pair<std::string, Input>> inputs_of(const Json& record) {
  std::vector<std::pair<std::string, Input>> inputs;
  const Json* const list = part(record, {"scene", "inputs"});
  if (list == nullptr) return inputs;
  std::map<std::string, int> seen;
  for (const Json& input : *list) {
    const std::string role = plain_text(input.at("role"));
    const int number = ++seen[role];
    const std::string hash = plain_text(input.at("fnv1a64"));
    inputs.emplace_back(number == 1 ? role : role + " " + std::to_string(number),
                        Input{plain_text(input.at("bytes")) + " " + hash,
                              plain_text(input.at("file")) + " (" + hash + ")"});
  }
  return inputs;
}

std::vector<Difference> compare_inputs(const Json& first, const Json& second) {
  const auto a = inputs_of(first), b = inputs_of(second);
  Values contents_a, contents_b;
  std::map<std::string, std::string> texts_a, texts_b;
  for (const auto& [role, input] : a) {
    contents_a.emplace_back(role, input.content);
    texts_a[role] = input.text;
  }
  for (const auto& [role, input] : b) {
    contents_b.emplace_back(role, input.content);
    texts_b[role] = input.text;
  }
  std::vector<Difference> differences = compare(contents_a, contents_b);
  for (Difference& difference : differences) {
    if (difference.first != kNoFigure) difference.first = texts_a[difference.what];
    if (difference.second != kNoFigure) difference.second = texts_b[difference.what];
  }
  return differences;
}

Values searched(const Json& record) {
  Values values;
  for (const char* end : {"first", "last"}) {
    for (auto& value : values_of(record, {"disparities", end}, std::string("disparities.") + end)) {
      values.push_back(std::move(value));
    }
  }
  return values;
}

Values figures(const Json& record) {
  Values values = values_of(record, {"threads"}, "threads");
  values = joined(values, values_of(record, {"seconds"}, "seconds"));
  values = joined(values, values_of(record, {"peak_memory_bytes"}, "peak_memory_bytes"));
  return joined(values, values_of(record, {"valid_share"}, "valid_share"));
}

}  // namespace

void compare_records(const Json& first, const Json& second, RunDiff& diff) {
  const auto configuration = [](const Json& record) {
    return joined(values_of(record, {"pipeline", "resolved"}), searched(record));
  };
  diff.configuration = compare(configuration(first), configuration(second));
  diff.program = compare(values_of(first, {"versions"}), values_of(second, {"versions"}));
  diff.inputs = compare_inputs(first, second);
  diff.figures = compare(figures(first), figures(second));
}

}  // namespace xgm
