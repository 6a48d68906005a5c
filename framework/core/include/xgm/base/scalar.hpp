// SPDX-License-Identifier: Apache-2.0
// Turns the text of scalars into values, strictly: all of the text must be the value.
#pragma once

#include <charconv>
#include <optional>
#include <string>

namespace xgm {

template <class Number>
std::optional<Number> to_number(const std::string& text) {
  const char* first = text.data();
  const char* last = first + text.size();
  const bool has_plus = first != last && *first == '+';
  if (has_plus) ++first;
  if (has_plus && first != last && *first == '-') return std::nullopt;
  Number value{};
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || first == last) return std::nullopt;
  return value;
}

inline std::optional<bool> to_bool(const std::string& text) {
  if (text == "true" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "False" || text == "FALSE") return false;
  return std::nullopt;
}

}  // namespace xgm
