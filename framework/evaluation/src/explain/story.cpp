// SPDX-License-Identifier: Apache-2.0
#include "explain/story.hpp"

#include <tuple>

#include "explain/levels.hpp"
#include "xgm/base/text.hpp"

namespace xgm::explain {
namespace {

std::string signed_number(double value) { return (value < 0 ? "" : "+") + number(value); }

/// What happened to the map that the run returns.
std::vector<const ExplainedEvent*> decisive_events(const Explanation& explanation) {
  std::vector<const ExplainedEvent*> events;
  for (const ExplainedEvent& event : explanation.events) {
    if (event.reverse || event.level.scale != 1 || !event.after) continue;
    if (!event.before) events.clear();  // matched anew
    if (event.effect != Effect::kept) events.push_back(&event);
  }
  return events;
}

std::string at_scale(const ExplainedEvent& event) {
  return stage_name(event) +
         (event.level.scale == 1 ? " at full scale" : " at " + level_name(event.level));
}

std::string loss(const Explanation& explanation, const ExplainedEvent& event) {
  const std::string reason(to_string(event.after->status));
  if (event.effect == Effect::killed) return "killed by " + at_scale(event) + ": " + reason;
  if (event.effect == Effect::relabelled) return "called " + reason + " by " + at_scale(event);
  std::string text = "not matched by " + at_scale(event) + ": " + reason;
  const bool nothing =
      !explanation.levels.empty() && explanation.levels.back().forward.range.empty();
  if (nothing) text += "; there is nothing to search";
  return text;
}

/// How a disparity came about, the stages that moved it included.
std::string gain(const ExplainedEvent& event) {
  switch (event.effect) {
    case Effect::matched:
      return "matched by " + at_scale(event) + " (" + state_text(*event.after) + ")";
    case Effect::filled:
      return "filled by " + at_scale(event);
    default: {
      const double shift = event.after->disparity - event.before->disparity;
      return "moved " + signed_number(shift) + " by " + stage_name(event);
    }
  }
}

}  // namespace

std::string number(double value) {
  std::string digits = fixed_number(value, 2);
  while (digits.ends_with('0')) digits.pop_back();
  if (digits.ends_with('.')) digits.pop_back();
  return digits;
}

std::string range_text(Interval range) {
  if (range.empty()) return "nothing";
  return std::to_string(range.begin) + " to " + std::to_string(range.end - 1);
}

std::string state_text(const PixelState& state) {
  return has_disparity(state.status) ? number(state.disparity)
                                     : std::string(to_string(state.status));
}

Effect effect_of(const std::optional<PixelState>& before, const PixelState& after) {
  const bool has = has_disparity(after.status);
  if (!before) return has ? Effect::matched : Effect::unmatched;
  if (*before == after) return Effect::kept;
  const bool had = has_disparity(before->status);
  if (had) return has ? Effect::changed : Effect::killed;
  return has ? Effect::filled : Effect::relabelled;
}

std::string change_text(const std::optional<PixelState>& before, const PixelState& after) {
  if (!before || *before == after) return state_text(after);
  std::string text = state_text(*before) + " -> " + state_text(after);
  if (effect_of(before, after) == Effect::changed) {
    text += " (" + signed_number(static_cast<double>(after.disparity) - before->disparity) + ")";
  }
  if (after.status != before->status && after.status == Status::filled) text += " (filled)";
  return text;
}

std::string stage_name(const ExplainedEvent& event) {
  const auto& [slot, plugin] = std::tie(event.place.slot, event.place.plugin);
  if (plugin.empty() || plugin == slot) return slot;
  return slot.empty() ? plugin : slot + " " + plugin;
}

std::string verdict(const Explanation& explanation) {
  const auto events = decisive_events(explanation);
  if (events.empty()) return "nothing was matched";
  const bool has = has_disparity(explanation.result.status);
  std::size_t from = events.size() - 1;  // where the present state begins
  while (from > 0 && has_disparity(events[from]->before->status) == has) --from;
  if (!has) {
    std::string text = loss(explanation, *events[from]);
    if (from + 1 < events.size()) text += "; " + loss(explanation, *events.back());
    return text;
  }
  std::string text = gain(*events[from]);
  for (std::size_t i = from + 1; i < events.size(); ++i) text += ", " + gain(*events[i]);
  if (from > 0) text += "; before that " + loss(explanation, *events[from - 1]);
  return text;
}

}  // namespace xgm::explain
