// SPDX-License-Identifier: Apache-2.0
#include "diff/records.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>

namespace xgm {
namespace {

/// What is compared, and what is shown of it.
struct Value {
  std::string name, content, text;
};
/// In the order of a record.
using Values = std::vector<Value>;

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
    for (const Json& element : json) {
      flatten(element, path + "[" + std::to_string(i++) + "]", values);
    }
  } else if (!json.is_null()) {
    values.push_back({path, plain_text(json), plain_text(json)});
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

Values joined(std::initializer_list<Values> lists) {
  Values all;
  for (const Values& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

Values configuration(const Json& record) {
  return joined({values_of(record, {"pipeline", "resolved"}),
                 values_of(record, {"disparities", "first"}, "disparities searched, first"),
                 values_of(record, {"disparities", "last"}, "disparities searched, last")});
}

/// By role and content; several files of one role are counted.
Values inputs(const Json& record) {
  Values values;
  const Json* const list = part(record, {"scene", "inputs"});
  if (list == nullptr) return values;
  std::map<std::string, int> seen;
  for (const Json& input : *list) {
    const std::string role = plain_text(input.at("role"));
    const int number = ++seen[role];
    const std::string hash = plain_text(input.at("fnv1a64"));
    values.push_back({number == 1 ? role : role + " " + std::to_string(number),
                      plain_text(input.at("bytes")) + " " + hash,
                      plain_text(input.at("file")) + " (" + hash + ")"});
  }
  return values;
}

Values figures(const Json& record) {
  return joined({values_of(record, {"threads"}, "threads"),
                 values_of(record, {"seconds"}, "seconds"),
                 values_of(record, {"peak_memory_bytes"}, "peak_memory_bytes"),
                 values_of(record, {"valid_share"}, "valid_share")});
}

const Value* find(const Values& values, const std::string& name) {
  const auto found = std::ranges::find(values, name, &Value::name);
  return found == values.end() ? nullptr : &*found;
}

/// In the order of the first; what only the second has comes last.
std::vector<Difference> compare(const Values& first, const Values& second) {
  std::vector<Difference> differences;
  for (const Value& value : first) {
    const Value* const other = find(second, value.name);
    if (other != nullptr && other->content == value.content) continue;
    differences.push_back({value.name, value.text, other != nullptr ? other->text : kNoFigure});
  }
  for (const Value& value : second) {
    if (find(first, value.name) == nullptr)
      differences.push_back({value.name, kNoFigure, value.text});
  }
  return differences;
}

}  // namespace

void compare_records(const Json& first, const Json& second, RunDiff& diff) {
  diff.configuration = compare(configuration(first), configuration(second));
  diff.program = compare(values_of(first, {"versions"}), values_of(second, {"versions"}));
  diff.inputs = compare(inputs(first), inputs(second));
  diff.figures = compare(figures(first), figures(second));
}

}  // namespace xgm
