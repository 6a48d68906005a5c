// SPDX-License-Identifier: Apache-2.0
// The tables in HTML.
#include "bench/table.hpp"

namespace xgm {
namespace {

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string render(const Table& table) {
  std::string out =
      "<h2>" + html_text(table.title) + "</h2>\n<div class=\"table\"><table>\n<thead><tr>";
  for (const std::string& head : table.header) {
    out += "<th scope=\"col\">" + html_text(head) + "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string text = html_text(row[c].text);
      out += c < table.names ? "<th scope=\"row\">" + text + "</th>"
             : row[c].best   ? "<td><b>" + text + "</b></td>"
                             : "<td>" + text + "</td>";
    }
    out += "</tr>\n";
  }
  out += "</tbody></table></div>\n";
  for (const std::string& note : table.notes)
    out += "<p class=\"note\">" + html_text(note) + "</p>\n";
  return out;
}

}  // namespace

std::string bench_tables_html(const BenchResult& result) {
  std::string out;
  if (result.interrupted) out += "<p><b>Interrupted: not all has been run.</b></p>\n";
  out += "<p>";
  for (const std::string& text : explanations(result)) out += html_text(text) + "\n";
  out += "</p>\n";
  for (const std::string& set : sets(result)) out += render(average_table(result, set));
  for (const std::string& set : sets(result)) out += render(scene_table(result, set));
  return out;
}

// Tables scroll within themselves on narrow screens.
constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;margin:1.5em;color:#111;background:#fff}"
    ".table{overflow-x:auto}table{border-collapse:collapse}"
    "th,td{padding:.2em .6em;border-bottom:1px solid #ccc;white-space:nowrap}"
    "td,thead th{text-align:right}tbody th{text-align:left;font-weight:normal}"
    "thead th:nth-child(-n+2){text-align:left}tbody tr:hover{background:#eef}";

std::string bench_html(const BenchResult& result) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<title>Bench</title><style>" +
         std::string(kStyle) + "</style></head>\n<body>\n<h1>Bench</h1>\n" +
         bench_tables_html(result) + "</body></html>\n";
}

}  // namespace xgm
