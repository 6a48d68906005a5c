// SPDX-License-Identifier: Apache-2.0
// The averages for terminals.
#include <algorithm>

#include "bench/table.hpp"
#include "xgm/base/text.hpp"

namespace xgm {
namespace {

/// Characters, not bytes: the bytes 10xxxxxx of UTF-8 continue one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string text_of(const TableCell& cell) { return cell.text + (cell.best ? "*" : ""); }

std::string render(const Table& table) {
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

/// What every figure depends on, in one line.
std::string legend(const BenchResult& result) {
  const BenchRules& rules = result.rules;
  std::string text = "shares in %, errors in px of ";
  text += rules.scale == 0 ? "the full resolution" : "the maps";
  if (rules.scale != 0 && rules.scale != 1) text += " times " + short_number(rules.scale);
  text += "; judged: " + (rules.region.empty() ? "non-occluded" : rules.region) + " pixels";
  if (rules.clip) text += ", clipped to the search range";
  const int threads = result.request.threads;
  return text + "; " + std::to_string(threads) + (threads == 1 ? " thread\n" : " threads\n");
}

}  // namespace

std::string bench_text(const BenchResult& result) {
  std::string out = legend(result);
  for (const std::string& set : sets(result)) {
    out += (set == sets(result).front() ? "" : "\n") + render(average_table(result, set));
  }
  return out + "* best of its column\n";
}

}  // namespace xgm
