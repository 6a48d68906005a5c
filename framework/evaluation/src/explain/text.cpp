// SPDX-License-Identifier: Apache-2.0
// An explanation for people.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "explain/levels.hpp"
#include "explain/plot.hpp"
#include "explain/story.hpp"

namespace xgm {
namespace {

using explain::level_name;
using explain::number;
using explain::range_text;
using explain::state_text;

constexpr std::size_t kWidth = 100;

std::string point_text(cv::Point p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

/// A line, broken between words where it is too long; what follows is indented.
std::string wrapped(const std::string& line, std::size_t indent) {
  std::string rest = line, text;
  while (rest.size() > kWidth) {
    std::size_t end = rest.rfind(' ', kWidth);
    if (end == std::string::npos || end <= indent) break;  // a word longer than a line
    text += rest.substr(0, end) + "\n";
    rest = std::string(indent, ' ') + rest.substr(end + 1);
  }
  return text + rest + "\n";
}

std::string figures(const Candidate& candidate) {
  std::string text;
  if (!std::isnan(candidate.cost)) text += "cost " + number(candidate.cost);
  if (!std::isnan(candidate.sum))
    text += (text.empty() ? "sum " : ", sum ") + number(candidate.sum);
  return text.empty() ? "cannot be matched" : text;
}

std::string candidate_text(const char* name, const std::optional<Candidate>& candidate) {
  if (!candidate) return std::string("no ") + name;
  return std::string(name) + " " + std::to_string(candidate->disparity) + " (" +
         figures(*candidate) + ")";
}

std::string choice_text(const MatchExplanation& match) {
  std::string text = candidate_text("winner", match.winner);
  if (match.winner) text += ", " + candidate_text("runner-up", match.runner_up);
  if (match.shift) text += ", shift " + number(*match.shift) + " px";
  return text;
}

bool has_curves(const MatchExplanation& match) {
  return !match.costs.empty() || !match.sums.empty();
}

std::string truth_text(const ExplainedTruth& truth, const MatchExplanation& match) {
  const std::string text = "truth " + number(truth.disparity);
  if (!truth.searched) return text + ": not within " + range_text(match.range);
  if (!has_curves(match)) return text + ": searched";
  const bool matchable = !std::isnan(truth.nearest.cost) || !std::isnan(truth.nearest.sum);
  return text + ": searched; " + std::to_string(truth.nearest.disparity) +
         (matchable ? " has " : " ") + figures(truth.nearest);
}

std::vector<explain::Mark> marks(const MatchExplanation& match) {
  std::vector<explain::Mark> list;
  if (match.winner) list.push_back({'W', match.winner->disparity});
  if (match.truth) list.push_back({'T', match.truth->nearest.disparity});
  if (match.runner_up) list.push_back({'R', match.runner_up->disparity});
  return list;
}

std::string level_text(const LevelExplanation& level) {
  const MatchExplanation& match = level.forward;
  std::string text =
      wrapped(level_name(level.level) + " (" + std::to_string(level.size.width) + " x " +
                  std::to_string(level.size.height) + "), pixel " + point_text(match.pixel) + ", " +
                  match.plugin + ", range " + range_text(match.range),
              2);
  text +=
      wrapped("  " + (has_curves(match) ? choice_text(match) : "the matcher shows no costs"), 4);
  if (match.truth) text += wrapped("  " + truth_text(*match.truth, match), 4);
  constexpr int kCostRows = 4, kSumRows = 6;
  text += explain::plot(match.costs, match.range, marks(match), "costs", kCostRows);
  text += explain::plot(match.sums, match.range, marks(match), "sums", kSumRows);
  if (const auto& reverse = level.reverse) {
    text += wrapped("  reverse view, pixel " + point_text(reverse->pixel) + ", range " +
                        range_text(reverse->range) + ": " + choice_text(*reverse) +
                        "; in the end " + state_text(reverse->result),
                    4);
  }
  return text + wrapped("  in the end: " + state_text(match.result), 4);
}

std::string events_text(const std::vector<ExplainedEvent>& events) {
  constexpr std::size_t kMaxName = 36;
  std::size_t width = 0, scale_width = 0;
  for (const ExplainedEvent& event : events) {
    const std::size_t length = explain::stage_name(event).size();
    if (length <= kMaxName) width = std::max(width, length);
    scale_width = std::max(scale_width, level_name(event.level).size());
  }
  std::string text;
  const auto padded = [](std::string word, std::size_t size) {
    word.resize(std::max(word.size(), size), ' ');
    return word + "  ";
  };
  for (const ExplainedEvent& event : events) {
    const std::string kept = event.effect == Effect::kept ? " (kept)" : "";
    text += wrapped("  " + padded(level_name(event.level), scale_width) +
                        padded(event.reverse ? "reverse" : "forward", 0) +
                        padded(explain::stage_name(event), width) + event.text + kept,
                    scale_width + width + 15);
  }
  return text;
}

}  // namespace

std::string to_text(const Explanation& explanation) {
  const PixelState& result = explanation.result;
  std::string text = "pixel " + point_text(explanation.pixel) + ": ";
  if (has_disparity(result.status)) text += number(result.disparity) + " px, ";
  text += std::string(to_string(result.status));
  if (explanation.truth) text += "; truth " + number(*explanation.truth) + " px";
  text += "\n\nwhat happened (disparities in px of the level; s8 = 1/8 of the size)\n" +
          events_text(explanation.events) +
          "\nlevels (W winner, R runner-up = best local minimum not beside it";
  text += std::string(explanation.truth ? ", T truth" : "") + "; sums in cost units)\n";
  for (const LevelExplanation& level : explanation.levels) text += level_text(level);
  text += "\n";
  if (!explanation.diagnosis.empty()) text += wrapped("where: " + explanation.diagnosis, 7);
  return text + wrapped("why: " + explanation.verdict, 5);
}

}  // namespace xgm
