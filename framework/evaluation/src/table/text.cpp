// SPDX-License-Identifier: Apache-2.0
// A table for terminals.
#include <algorithm>

#include "xgm/evaluation/table.hpp"

namespace xgm {
namespace {

/// Characters, not bytes: the bytes 10xxxxxx of UTF-8 continue one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string text_of(const TableCell& cell) { return cell.text + (cell.best ? "*" : ""); }

}  // namespace

std::string table_text(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    widths.push_back(width(table.header[c]));
    for (const auto& row : table.rows) widths[c] = std::max(widths[c], width(text_of(row[c])));
  }
  std::string out = table.title + "\n";
  const auto line = [&](auto text_at) {
    std::string text;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string cell = text_at(c);
      const std::string padding(widths[c] - width(cell), ' ');
      text += (c == 0 ? "" : "  ") + (c < table.names ? cell + padding : padding + cell);
    }
    out += text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  };
  line([&](std::size_t c) { return table.header[c]; });
  for (const auto& row : table.rows) line([&](std::size_t c) { return text_of(row[c]); });
  for (const std::string& note : table.notes) out += note + "\n";
  return out;
}

}  // namespace xgm
