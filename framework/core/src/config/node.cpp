// SPDX-License-Identifier: Apache-2.0
#include "config/node.hpp"

#include <algorithm>

namespace xgm {

Entry* Node::find(std::string_view key) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

const Entry* Node::find(std::string_view key) const { return const_cast<Node*>(this)->find(key); }

std::string without_controls(std::string text) {
  constexpr unsigned char kFirstPrintable = 32, kDelete = 127;
  const auto is_control = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < kFirstPrintable || code == kDelete;
  };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  const std::string shown = without_controls(std::string(text.substr(0, kLongest)));
  return "'" + shown + (text.size() > kLongest ? "..." : "") + "'";
}

std::string spell(const Node& node) {
  switch (node.kind) {
    case Node::Kind::scalar:
      return node.quoted ? "the text " + quote(node.scalar) : quote(node.scalar);
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      return "a map";
    case Node::Kind::null:
      break;
  }
  return "nothing";
}

void add_diagnostic(Diagnostics& diagnostics, Location where, std::string message,
                    std::string remedy) {
  Diagnostic& added = diagnostics.emplace_back();
  added.where = std::move(where);
  added.message = std::move(message);
  added.remedy = std::move(remedy);
}

std::string to_string(const Diagnostic& diagnostic) {
  const Location& where = diagnostic.where;
  std::string text = where.file;
  if (where.line > 0) text += ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
  text += ": error: " + diagnostic.message;
  if (!diagnostic.remedy.empty()) text += "; " + diagnostic.remedy;
  return without_controls(std::move(text));
}

std::string to_string(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) text += (text.empty() ? "" : "\n") + to_string(d);
  return text;
}

}  // namespace xgm
