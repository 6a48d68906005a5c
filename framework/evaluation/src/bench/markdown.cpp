// SPDX-License-Identifier: Apache-2.0
// The tables in Markdown.
#include "bench/table.hpp"

namespace xgm {
std::string bench_markdown(const BenchResult& result) {
  std::string out = "# Bench\n\n";
  if (result.interrupted) out += "**Interrupted: not all has been run.**\n\n";
  for (const std::string& text : explanations(result)) out += markdown_text(text) + "\n";
  for (const std::string& set : sets(result)) out += table_markdown(average_table(result, set));
  for (const std::string& set : sets(result)) out += table_markdown(scene_table(result, set));
  return out;
}

}  // namespace xgm
