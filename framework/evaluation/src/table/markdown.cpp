// SPDX-License-Identifier: Apache-2.0
// A table in Markdown.
#include "xgm/evaluation/table.hpp"

namespace xgm {
namespace {

std::string text_of(const TableCell& cell) {
  return cell.best ? "**" + markdown_text(cell.text) + "**" : markdown_text(cell.text);
}

}  // namespace

/// An underscore within a word is harmless.
std::string markdown_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string("\\`*<>|[]").find(c) != std::string::npos) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

std::string table_markdown(const Table& table) {
  std::string out = "\n## " + markdown_text(table.title) + "\n\n|";
  for (const std::string& head : table.header) out += " " + markdown_text(head) + " |";
  out += "\n|";
  for (std::size_t c = 0; c < table.header.size(); ++c) out += c < table.names ? "---|" : "--:|";
  for (const auto& row : table.rows) {
    out += "\n|";
    for (const TableCell& cell : row) out += " " + text_of(cell) + " |";
  }
  out += "\n";
  if (!table.notes.empty()) out += "\n";
  for (const std::string& note : table.notes) out += "- " + markdown_text(note) + "\n";
  return out;
}

}  // namespace xgm
