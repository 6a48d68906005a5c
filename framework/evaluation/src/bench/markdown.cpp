// SPDX-License-Identifier: Apache-2.0
// The tables in Markdown.
#include "bench/table.hpp"

namespace xgm {
namespace {

/// What means something to Markdown, or to the HTML in it, means nothing. An underscore within a
/// word is harmless.
std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string("\\`*<>|[]").find(c) != std::string::npos) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

std::string text_of(const TableCell& cell) {
  return cell.best ? "**" + escape(cell.text) + "**" : escape(cell.text);
}

std::string render(const Table& table) {
  std::string out = "\n## " + escape(table.title) + "\n\n|";
  for (const std::string& head : table.header) out += " " + escape(head) + " |";
  out += "\n|";
  for (std::size_t c = 0; c < table.header.size(); ++c) out += c < table.names ? "---|" : "--:|";
  for (const auto& row : table.rows) {
    out += "\n|";
    for (const TableCell& cell : row) out += " " + text_of(cell) + " |";
  }
  out += "\n";
  if (!table.notes.empty()) out += "\n";
  for (const std::string& note : table.notes) out += "- " + escape(note) + "\n";
  return out;
}

}  // namespace

std::string bench_markdown(const BenchResult& result) {
  std::string out = "# Bench\n\n";
  if (result.interrupted) out += "**Interrupted: not all has been run.**\n\n";
  for (const std::string& text : explanations(result)) out += escape(text) + "\n";
  for (const std::string& set : sets(result)) out += render(average_table(result, set));
  for (const std::string& set : sets(result)) out += render(scene_table(result, set));
  return out;
}

}  // namespace xgm
