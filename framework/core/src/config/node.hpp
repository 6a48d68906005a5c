// SPDX-License-Identifier: Apache-2.0
// A configuration as read: scalars, lists and maps that know where they stand. The only file format
// aware code is the reader; the binder sees this.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/config/diagnostics.hpp"

namespace xgm {

struct Entry;

struct Node {
  enum class Kind { null, scalar, list, map };

  Kind kind = Kind::null;
  Location where;
  std::string scalar;
  bool quoted = false;         ///< a quoted scalar is text, whatever it looks like
  std::vector<Node> items;     ///< of a list
  std::vector<Entry> entries;  ///< of a map, in file order, duplicates included

  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }
  bool is_null() const { return kind == Kind::null; }
  /// The first entry of that key, or null.
  Entry* find(std::string_view key);
  const Entry* find(std::string_view key) const;
};

struct Entry {
  std::string key;
  Location where;
  Node value;
};

/// How a node is called in messages: 'five', a list, a map, nothing.
std::string spell(const Node& node);
/// The text in one line that moves no cursor: control characters are blanks.
std::string without_controls(std::string text);
/// 'text', cut and cleaned for a one-line message.
std::string quote(std::string_view text);

/// Adds a diagnostic.
void add_diagnostic(Diagnostics& diagnostics, Location where, std::string message,
                    std::string remedy);

/// Far above any sensible pipeline; stops files that have no end.
inline constexpr std::size_t kMaxYamlBytes = std::size_t{1} << 24;

/// Reads one YAML document. What is wrong with its syntax goes to `diagnostics`; nothing is
/// returned then.
std::optional<Node> read_yaml(const std::string& text, const std::string& name,
                              Diagnostics& diagnostics);

}  // namespace xgm
