// SPDX-License-Identifier: Apache-2.0
// A table in HTML.
#include "xgm/evaluation/report.hpp"
#include "xgm/evaluation/table.hpp"

namespace xgm {
namespace {

std::string cell_html(const TableCell& cell) {
  const std::string text = html_text(cell.text);
  return cell.best ? "<td><b>" + text + "</b></td>" : "<td>" + text + "</td>";
}

}  // namespace

// Tables scroll within themselves on narrow screens.
const char* const kTableStyle =
    "<style>.bench{overflow-x:auto}.bench table{border-collapse:collapse;"
    "font-variant-numeric:tabular-nums}"
    ".bench th,.bench td{padding:.15em .6em;border-bottom:1px solid #8886;white-space:nowrap;"
    "text-align:right}.bench tbody th{font-weight:normal}"
    ".bench th:nth-child(-n+2){text-align:left}.bench tbody tr:hover{background:#8883}</style>\n";

std::string table_html(const Table& table) {
  std::string out =
      "<h2>" + html_text(table.title) + "</h2>\n<div class=\"bench\"><table>\n<thead><tr>";
  for (const std::string& head : table.header) {
    out += "<th scope=\"col\">" + html_text(head) + "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      out += c < table.names ? "<th scope=\"row\">" + html_text(row[c].text) + "</th>"
                             : cell_html(row[c]);
    }
    out += "</tr>\n";
  }
  out += "</tbody></table></div>\n";
  for (const std::string& note : table.notes) out += "<p>" + html_text(note) + "</p>\n";
  return out;
}

}  // namespace xgm
