// SPDX-License-Identifier: Apache-2.0
// The tables in HTML, and the page that they stand on.
#include "bench/table.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm {
std::string bench_tables_html(const BenchResult& result) {
  std::string out = kTableStyle;
  if (result.interrupted) out += "<p><b>Interrupted: not all has been run.</b></p>\n";
  out += "<p>";
  for (const std::string& text : explanations(result)) out += html_text(text) + "\n";
  out += "</p>\n";
  for (const std::string& set : sets(result)) out += table_html(average_table(result, set));
  for (const std::string& set : sets(result)) {
    out += "<details><summary>" + html_text(set) + ", scene by scene</summary>\n" +
           table_html(scene_table(result, set)) + "</details>\n";
  }
  return out;
}

}  // namespace xgm
