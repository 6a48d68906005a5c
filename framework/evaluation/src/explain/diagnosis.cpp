// SPDX-License-Identifier: Apache-2.0
// With a known truth: which step took the wrong turn.
#include <cmath>

#include "explain/levels.hpp"
#include "explain/story.hpp"

namespace xgm::explain {
namespace {

constexpr double kClose = 1;  // px: what counts as right, as in the benchmarks' bad 1.0

bool close(double disparity, double truth) { return std::abs(disparity - truth) <= kClose; }

/// The first level, from coarse to fine, that did not search the truth; null if all did.
const LevelExplanation* blind_level(const Explanation& explanation) {
  for (const LevelExplanation& level : explanation.levels) {
    if (level.forward.truth && !level.forward.truth->searched) return &level;
  }
  return nullptr;
}

std::string lost_range(const Explanation& explanation, const LevelExplanation& level) {
  std::string text = "range: " + level_name(level.level) + " searched " +
                     range_text(level.forward.range) + ", the truth is " +
                     number(level.forward.truth->disparity);
  if (&level == &explanation.levels.front()) return text + ", outside of what was asked for";
  const LevelExplanation& coarser = *(&level - 1);
  return text + "; " + level_name(coarser.level) + " had said " +
         state_text(coarser.forward.result) + " for " + number(coarser.forward.truth->disparity);
}

/// The truth was searched at the last level, another disparity won there.
std::string lost_match(const MatchExplanation& match) {
  const Candidate& won = *match.winner;
  const Candidate& truth = match.truth->nearest;
  const std::string pair =
      std::to_string(won.disparity) + " over " + std::to_string(truth.disparity) + ": ";
  const auto figures = [](const char* what, float a, float b) {
    return std::string(what) + " " + number(a) + " and " + number(b);
  };
  if (std::isnan(match.costs.empty() ? truth.sum : truth.cost)) {
    return "the truth cannot be matched: its pixel in the other view has no data or lies outside";
  }
  if (std::isnan(won.cost) || std::isnan(truth.cost)) {
    return "matching prefers " + pair + figures("sums", won.sum, truth.sum);
  }
  const std::string costs = figures("costs", won.cost, truth.cost);
  const std::string sums = figures("sums", won.sum, truth.sum);
  if (won.cost < truth.cost) return "cost: it prefers " + pair + costs + ", " + sums;
  return "aggregation: the cost does not prefer " + pair + costs + ", but " + sums;
}

}  // namespace

std::string diagnosis(const Explanation& explanation) {
  if (!explanation.truth || explanation.levels.empty()) return {};
  const double truth = *explanation.truth;
  const PixelState& result = explanation.result;
  const bool has = has_disparity(result.status);
  if (has && close(result.disparity, truth)) return "right: within 1 px of the truth";
  if (const LevelExplanation* blind = blind_level(explanation)) {
    return lost_range(explanation, *blind);
  }
  const MatchExplanation& match = explanation.levels.back().forward;
  if (!match.winner)
    return "the matcher shows no costs; its result was " + state_text(match.result);
  if (!close(match.winner->disparity, match.truth->disparity)) return lost_match(match);
  return "matched right as " + std::to_string(match.winner->disparity) + ", then " +
         (has ? "moved away: " : "taken away: ") + verdict(explanation);
}

}  // namespace xgm::explain
