// SPDX-License-Identifier: Apache-2.0
// What stages returned, compared with what they were given.
#include <algorithm>
#include <cmath>
#include <limits>

#include "explain/curve.hpp"
#include "explain/levels.hpp"
#include "explain/story.hpp"
#include "explain/watcher.hpp"
#include "xgm/stage/fuser.hpp"

namespace xgm::explain {
namespace {

PixelState state_at(const DisparityMap& map, cv::Point at) {
  return {map.disparity(at), map.at(at.y, at.x)};
}

bool same_row(const Image& a, const Image& b, int y) {
  if (a.planes.size() != b.planes.size()) return false;
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    if (!std::equal(a.planes[i][y], a.planes[i][y] + a.planes[i].cols, b.planes[i][y])) {
      return false;
    }
  }
  return true;
}

/// "occluded" is told with what the other view says.
std::string other_view_text(const MatchResult& maps, cv::Point at) {
  if (!maps.reverse) return {};
  const PixelState forward = state_at(maps.forward, at);
  if (!has_disparity(forward.status)) return {};
  const cv::Point there = pointed_at(at, forward.disparity);
  const std::string place = " (reverse view at x = " + std::to_string(there.x);
  if (!cv::Rect({}, maps.forward.size()).contains(there)) {
    return place + " lies outside the image)";
  }
  const PixelState back = state_at(*maps.reverse, there);
  if (has_disparity(back.status)) return place + " says " + number(back.disparity) + ")";
  return place + " has none: " + state_text(back) + ")";
}

/// Why a selection that had candidates chose none of them.
std::string rivals_text(MatchExplanation match) {
  find_candidates(match);
  const std::vector<float>& curve = decisive(match);
  if (match.range.empty()) return " (nothing to search)";
  if (!match.winner) return " (nothing of " + range_text(match.range) + " can be matched)";
  const auto told = [&](const Candidate& c) {
    const float height = curve[static_cast<std::size_t>(c.disparity - match.range.begin)];
    return std::to_string(c.disparity) + " at " + number(height);
  };
  std::string text = " (lowest " + told(*match.winner);
  if (match.runner_up) text += ", runner-up " + told(*match.runner_up);
  return text + ")";
}

}  // namespace

void Watcher::end(const StagePlace& place, const Artifact& result) {
  Frame* frame = open_frame(place);
  if (frame == nullptr) return;
  if (const auto* pair = std::get_if<const ImagePair*>(&result)) {
    images_returned(*frame, **pair);
  } else if (const auto* range = std::get_if<const DisparityRange*>(&result)) {
    range_returned(*frame, **range);
  } else if (const auto* costs = std::get_if<const CostVolume*>(&result)) {
    take_costs(*frame, **costs);
  } else if (const auto* sums = std::get_if<const AggregatedVolume*>(&result)) {
    take_sums(*frame, **sums);
  } else if (const auto* map = std::get_if<const DisparityMap*>(&result)) {
    map_returned(*frame, **map);
  } else if (const auto* maps = std::get_if<const MatchResult*>(&result)) {
    maps_returned(*frame, **maps);
  }
  frames_.pop_back();
}

void Watcher::images_returned(const Frame& frame, const ImagePair& result) {
  if (frame.pair == nullptr || frame.is_reverse() || result.size() != frame.pair->size()) return;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const cv::Point at = place_of(i, frame, result.size());
    const bool left = same_row(frame.pair->base, result.base, at.y);
    const bool right = same_row(frame.pair->match, result.match, at.y);
    std::string text = left && right ? "leaves both images' rows as they are"
                       : left        ? "changes this row of the match image"
                       : right       ? "changes this row of the base image"
                                     : "changes this row of both images";
    if (frame.pair->base.is_valid(at.y, at.x) && !result.base.is_valid(at.y, at.x)) {
      text += ", masks this pixel";
    }
    tell(i, frame, Effect::images, text + frame.figures);
  }
}

void Watcher::range_returned(const Frame& frame, const DisparityRange& result) {
  if (frame.is_reverse()) return;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const cv::Point at = place_of(i, frame, result.size());
    tell(i, frame, Effect::range, "proposes " + range_text(result.at(at.y, at.x)));
  }
}

void Watcher::map_returned(Frame& frame, const DisparityMap& result) {
  const bool same_size = frame.map != nullptr && frame.map->size() == result.size();
  Frame* matcher = matcher_of(frame);
  const bool in_matcher = matcher != nullptr && matcher->size == result.size();
  Track& here = track(result.size(), frame.place.level, frame.is_reverse());
  if (in_matcher && frame.sums != nullptr && !same_size) match_of(*matcher);
  frame.result = &result;
  follow(frame, here, same_size ? frame.map : nullptr, result);
  if (!in_matcher || frame.sums == nullptr) return;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    if (here.at[i].x < 0) continue;
    MatchExplanation& match = match_of(*matcher).of[i];
    const PixelState after = state_at(result, here.at[i]);
    if (!has_disparity(after.status)) continue;
    if (same_size) {  // map and sums: a refinement
      match.shift = after.disparity - frame.map->disparity(here.at[i]);
    } else {  // sums only: a selection
      match.winner = Candidate{static_cast<int>(std::lround(after.disparity))};
    }
  }
}

void Watcher::maps_returned(Frame& frame, const MatchResult& result) {
  if (frame.request != nullptr && !frame.holds_matcher) match_of(frame);
  if (!frame.same_as.empty()) take_curves(frame);
  const MatchResult* given = frame.maps;
  Track& here = track(result.forward.size(), frame.place.level, frame.is_reverse());
  follow(frame, here, given != nullptr ? &given->forward : nullptr, result.forward);
  propose(frame, here, result.forward);
  if (!result.reverse) return;
  const bool both = given != nullptr && given->reverse;
  follow(frame, track(result.reverse->size(), frame.place.level, !frame.is_reverse()),
         both ? &*given->reverse : nullptr, *result.reverse);
}

/// Tells what the stage did to each pixel of a map; first what happened to it since the stage
/// before, which the matcher around must have done.
void Watcher::follow(const Frame& frame, Track& here, const DisparityMap* before,
                     const DisparityMap& after) {
  const bool is_matcher = frame.request != nullptr;
  const Frame* matcher = matcher_of(frame);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    if (here.at[i].x < 0) continue;
    std::optional<PixelState>& state = here.state[i];
    if (before != nullptr) {
      const PixelState given = state_at(*before, here.at[i]);
      if (state != given) record(i, matcher != nullptr ? *matcher : frame, here, state, given);
      state = given;
    }
    const PixelState now = state_at(after, here.at[i]);
    if (!is_matcher || state != now) record(i, frame, here, state, now);
    state = now;
    if (here.match != nullptr) here.match->of[i].result = now;
  }
}

void Watcher::record(std::size_t i, const Frame& frame, const Track& here,
                     const std::optional<PixelState>& before, const PixelState& after) {
  const Effect effect = effect_of(before, after);
  std::string text = change_text(before, after);
  if (effect == Effect::killed && frame.maps != nullptr && !here.reverse) {
    text += other_view_text(*frame.maps, here.at[i]);
  }
  if (effect == Effect::unmatched && frame.sums != nullptr && here.match != nullptr) {
    text += rivals_text(here.match->of[i]);
  }
  if (!frame.same_as.empty()) text += " (found by " + frame.same_as + ")";
  if (frame.place.kind == Fuser::kKind) text += choice_text(i, frame, here, after);
  events_[i].push_back(
      {frame.place, here.level, here.reverse, effect, before, after, std::move(text)});
}

/// Remembers for the stage around a matcher what that found.
void Watcher::propose(const Frame& frame, const Track& here, const DisparityMap& result) {
  if (frame.request == nullptr || frame.is_reverse() || frames_.size() < 2) return;
  Proposal proposal{frame.place.slot + " " + frame.place.plugin, {}};
  for (const cv::Point at : here.at) proposal.states.push_back(state_at(result, at));
  frames_[frames_.size() - 2].proposals.push_back(std::move(proposal));
}

/// Which matchers a disparity was taken from, or is nearest to if it is a mean of several; how sure
/// that is; and what the others say.
std::string Watcher::choice_text(std::size_t i, const Frame& frame, const Track& here,
                                 const PixelState& choice) const {
  if (here.reverse || frames_.size() < 2) return {};
  const std::vector<Proposal>& proposals = frames_[frames_.size() - 2].proposals;
  const auto distance = [&](const Proposal& proposal) {  // NaN if one has no disparity
    return std::abs(proposal.states[i].disparity - choice.disparity);
  };
  float least = std::numeric_limits<float>::infinity();
  for (const Proposal& proposal : proposals) least = std::fmin(least, distance(proposal));
  std::string from, others;
  for (const Proposal& proposal : proposals) {
    if (distance(proposal) == least) {
      from += (from.empty() ? "" : ", ") + proposal.stage;
    } else {
      others += "; " + proposal.stage + " says " + state_text(proposal.states[i]);
    }
  }
  if (from.empty()) return {};
  const cv::Mat1f& confidence = frame.result->confidence;
  const bool sure = !confidence.empty() && std::isfinite(confidence(here.at[i]));
  return (least == 0 ? " (from " : " (nearest to ") + from +
         (sure ? "; confidence " + number(confidence(here.at[i])) : "") + others + ")";
}

void Watcher::tell(std::size_t i, const Frame& frame, Effect effect, std::string text) {
  events_[i].push_back(
      {frame.place, frame.place.level, false, effect, std::nullopt, std::nullopt, std::move(text)});
}

}  // namespace xgm::explain
