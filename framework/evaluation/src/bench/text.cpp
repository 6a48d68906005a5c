// SPDX-License-Identifier: Apache-2.0
// The averages for terminals.
#include "xgm/base/text.hpp"
#include "bench/table.hpp"

namespace xgm {
namespace {

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
    out += (set == sets(result).front() ? "" : "\n") + table_text(average_table(result, set));
  }
  return out + "* best of its column\n";
}

}  // namespace xgm
