// SPDX-License-Identifier: Apache-2.0
#include "report/yaml_text.hpp"

#include <algorithm>
#include <cctype>

namespace xgm::report {
namespace {

constexpr std::size_t kLineWidth = 76;

/// Words need no quotes; JSON's notation of everything else is YAML, too.
std::string scalar(const Json& value) {
  if (!value.is_string()) return value.dump();
  const std::string& text = value.text();
  const bool is_word = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
                       std::all_of(text.begin(), text.end(), [](unsigned char c) {
                         return std::isalnum(c) != 0 || c == '_';
                       });
  static const std::vector<std::string> kReserved{"true", "false", "yes", "no", "on",
                                                  "off",  "null",  "y",   "n"};
  std::string lower = text;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool reserved = std::find(kReserved.begin(), kReserved.end(), lower) != kReserved.end();
  return is_word && !reserved ? text : value.dump();
}

std::string in_one_line(const Json& value) {
  if (!value.is_structured()) return scalar(value);
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  if (value.is_array()) {
    for (const Json& item : value) add(in_one_line(item));
    return "[" + text + "]";
  }
  for (const auto& [key, item] : value.members()) add(scalar(key) + ": " + in_one_line(item));
  return "{" + text + "}";
}

bool is_flat(const Json& value) {
  const auto is_plain = [](const Json& item) { return !item.is_structured() || item.empty(); };
  if (value.is_array()) return std::all_of(value.begin(), value.end(), is_plain);
  return std::all_of(value.members().begin(), value.members().end(),
                     [&](const Json::Member& member) { return is_plain(member.second); });
}

void write(const Json& value, std::size_t indent, std::string& text);

/// What stands behind "key:" or "-".
void write_item(const Json& item, std::size_t indent, std::string& text) {
  const std::string line = in_one_line(item);
  const bool fits = indent + line.size() <= kLineWidth;
  if (!item.is_structured() || item.empty() || (is_flat(item) && fits)) {
    text += " " + line + "\n";
    return;
  }
  text += "\n";
  write(item, indent, text);
}

void write(const Json& value, std::size_t indent, std::string& text) {
  const auto add = [&](const std::string& head, const Json& item) {
    text += std::string(indent, ' ') + head;
    write_item(item, indent + 2, text);
  };
  if (value.is_array()) {
    for (const Json& item : value) add("-", item);
  } else {
    for (const auto& [key, item] : value.members()) add(scalar(key) + ":", item);
  }
}

}  // namespace

std::string yaml_text(const Json& value) {
  std::string text;
  if (!value.is_structured() || value.empty()) return in_one_line(value) + "\n";
  write(value, 0, text);
  return text;
}

}  // namespace xgm::report
