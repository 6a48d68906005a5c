// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/table.hpp"

#include <cmath>
#include <map>

#include "xgm/base/text.hpp"

namespace xgm {

std::string figure_text(double value, int decimals) {
  if (!std::isfinite(value)) return kNoFigure;
  return fixed_number(value, decimals);
}

void mark_best(const std::vector<std::vector<TableCell>*>& rows, std::size_t names,
               const std::vector<Best>& columns) {
  if (rows.size() < 2) return;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c] == Best::none) continue;
    std::map<double, std::vector<TableCell*>> ranking;
    for (std::vector<TableCell>* row : rows) {
      TableCell& cell = (*row)[names + c];
      if (cell.text != kNoFigure) ranking[std::stod(cell.text)].push_back(&cell);
    }
    if (ranking.empty()) continue;
    auto& best = columns[c] == Best::lowest ? ranking.begin()->second : ranking.rbegin()->second;
    for (TableCell* cell : best) cell->best = true;
  }
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string csv_number(double value) { return std::isfinite(value) ? short_number(value) : ""; }

}  // namespace xgm
