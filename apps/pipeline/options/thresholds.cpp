// SPDX-License-Identifier: Apache-2.0
#include "options/thresholds.hpp"

#include "options/values.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/metrics.hpp"

namespace xgm::cli {

void add_thresholds_option(Command command, std::string& thresholds) {
  command.option("--thresholds", thresholds, "Errors above these are bad, px after --scale")
      .type_name("PX,PX,...")
      .show_default("0.5,1,2,4");
}

std::vector<double> parse_thresholds(const std::string& text) {
  if (text.empty()) return usual_thresholds();
  std::vector<double> deltas;
  for (const std::string& item : split_at_commas(text)) {
    const auto delta = parse_number(item);
    if (!delta || *delta < 0 || (!deltas.empty() && *delta <= deltas.back())) {
      throw UsageError("--thresholds " + text +
                       ": write rising numbers of px, 0 or more, for example 0.5,1,2,4");
    }
    deltas.push_back(*delta);
  }
  return deltas;
}

}  // namespace xgm::cli
