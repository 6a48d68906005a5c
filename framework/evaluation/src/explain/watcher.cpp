// SPDX-License-Identifier: Apache-2.0
// Which stages run, and what they were given.
#include "explain/watcher.hpp"

#include <algorithm>

#include "explain/curve.hpp"
#include "explain/levels.hpp"
#include "explain/story.hpp"

namespace xgm::explain {

Watcher::Watcher(cv::Size size, std::vector<cv::Point> pixels)
    : size_(size), pixels_(std::move(pixels)), events_(pixels_.size()) {}

void Watcher::begin(const StagePlace& place) {
  Frame frame;
  frame.place = place;
  frame.place.stage = nullptr;  // the pipeline may be gone before this
  frame.size = frames_.empty() ? size_ : frames_.back().size;
  frames_.push_back(std::move(frame));
}

/// The innermost running stage at this place. Stages that failed, and were caught, never end: they
/// are above it and are forgotten.
Watcher::Frame* Watcher::open_frame(const StagePlace& place) {
  const auto found = std::find_if(frames_.rbegin(), frames_.rend(), [&](const Frame& frame) {
    return frame.place.path == place.path;
  });
  if (found == frames_.rend()) return nullptr;
  frames_.resize(static_cast<std::size_t>(frames_.rend() - found));
  return &frames_.back();
}

/// The matcher that `frame`, the innermost one, works for.
Watcher::Frame* Watcher::matcher_of(const Frame& frame) {
  const auto found = std::find_if(frames_.rbegin(), frames_.rend(),
                                  [](const Frame& outer) { return outer.request != nullptr; });
  const bool same = found != frames_.rend() && found->place.view == frame.place.view;
  return same ? &*found : nullptr;
}

void Watcher::input(const StagePlace& place, const Artifact& input) {
  Frame* frame = open_frame(place);
  if (frame == nullptr) return;
  if (const auto* request = std::get_if<const MatchRequest*>(&input)) {
    take_request(*frame, **request);
  } else if (const auto* pair = std::get_if<const ImagePair*>(&input)) {
    frame->pair = *pair;
    frame->size = (*pair)->size();
  } else if (const auto* costs = std::get_if<const CostVolume*>(&input)) {
    take_costs(*frame, **costs);  // what is aggregated is what counts, whatever made it
  } else if (const auto* sums = std::get_if<const AggregatedVolume*>(&input)) {
    frame->sums = *sums;
    take_sums(*frame, **sums);
  } else if (const auto* map = std::get_if<const DisparityMap*>(&input)) {
    frame->map = *map;
  } else if (const auto* maps = std::get_if<const MatchResult*>(&input)) {
    frame->maps = *maps;
  }
}

void Watcher::take_request(Frame& frame, const MatchRequest& request) {
  for (Frame& outer : frames_) {
    if (&outer != &frame && outer.request != nullptr) outer.holds_matcher = true;
  }
  frame.request = &request;
  frame.size = request.pair.size();
  Track& here = track(frame.size, frame.place.level, frame.is_reverse());
  start(here);
  if (frame.is_reverse() || frame.size == announced_) return;
  announced_ = frame.size;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const cv::Point at = here.at[i];
    tell(i, frame, Effect::range, "range " + range_text(request.range.at(at.y, at.x)));
  }
}

void Watcher::take_costs(Frame& frame, const CostVolume& costs) {
  Frame* matcher = matcher_of(frame);
  if (matcher == nullptr || matcher->size != costs.shape().size()) return;
  for (MatchExplanation& match : match_of(*matcher).of) {
    if (match.pixel.x >= 0) take_cells(costs, 1, match, &MatchExplanation::costs);
  }
}

void Watcher::take_sums(Frame& frame, const AggregatedVolume& sums) {
  Frame* matcher = matcher_of(frame);
  if (matcher == nullptr || matcher->size != sums.shape().size()) return;
  const auto units = static_cast<float>(1 << sums.fraction_bits);
  for (MatchExplanation& match : match_of(*matcher).of) {
    if (match.pixel.x >= 0) take_cells(sums, units, match, &MatchExplanation::sums);
  }
}

void Watcher::same_as(const StagePlace& place, const std::string& earlier) {
  if (Frame* frame = open_frame(place)) frame->same_as = earlier;
}

void Watcher::figure(const StagePlace& place, const std::string& name, double value) {
  if (frames_.empty() || frames_.back().place.path != place.path) return;
  frames_.back().figures += ", " + name + " " + number(value);
}

/// The track of a view at a size; made if there is none.
Watcher::Track& Watcher::track(cv::Size size, const Level& level, bool reverse) {
  for (Track& known : tracks_) {
    if (known.size == size && known.reverse == reverse) return known;
  }
  Track& made = tracks_.emplace_back();
  made.size = size;
  made.level = level;
  made.reverse = reverse;
  start(made);
  return made;
}

/// Matching begins anew. The reverse view is watched where the forward result points at.
void Watcher::start(Track& here) {
  here.match = nullptr;
  here.state.assign(pixels_.size(), std::nullopt);
  here.at.assign(pixels_.size(), {-1, -1});
  if (here.reverse) {
    const Track& forward = track(here.size, here.level, false);
    for (std::size_t i = 0; i < pixels_.size(); ++i) here.at[i] = counterpart(forward, i);
  } else {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      here.at[i] = at_level(pixels_[i], size_, here.size, here.level.scale);
    }
  }
}

/// Where pixel i lies in images of `size` that the stage works on.
cv::Point Watcher::place_of(std::size_t i, const Frame& frame, cv::Size size) const {
  return at_level(pixels_[i], size_, size, frame.place.level.scale);
}

/// Where the forward disparity points at; if the pixel has lost it, where the lowest cell does.
cv::Point Watcher::counterpart(const Track& forward, std::size_t i) const {
  const cv::Point none(-1, -1);
  cv::Point there = none;
  if (forward.state[i] && has_disparity(forward.state[i]->status)) {
    there = pointed_at(forward.at[i], forward.state[i]->disparity);
  } else if (forward.match != nullptr) {
    MatchExplanation match = forward.match->of[i];
    find_candidates(match);
    if (match.winner) {
      there = pointed_at(forward.at[i], static_cast<float>(match.winner->disparity));
    }
  }
  return cv::Rect({}, forward.size).contains(there) ? there : none;
}

/// What this matcher did; begun when there is something to tell.
Match& Watcher::match_of(Frame& matcher) {
  if (matcher.match != nullptr) return *matcher.match;
  Track& here = track(matcher.size, matcher.place.level, matcher.is_reverse());
  Match& match = matches_.emplace_back();
  match.size = matcher.size;
  match.level = matcher.place.level;
  match.reverse = matcher.is_reverse();
  match.of.resize(pixels_.size());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    match.of[i].stage_path = matcher.place.path;
    match.of[i].plugin = matcher.place.plugin;
    match.of[i].pixel = here.at[i];
    if (here.at[i].x < 0) continue;
    match.of[i].range = matcher.request->range.at(here.at[i].y, here.at[i].x);
  }
  here.match = matcher.match = &match;
  return match;
}

/// Of the stage whose result this matcher is given: what led to it.
void Watcher::take_curves(Frame& matcher) {
  Match& here = match_of(matcher);
  for (const Match& earlier : matches_) {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const MatchExplanation& there = earlier.of[i];
      const bool is_it = there.stage_path == matcher.same_as ||
                         there.stage_path.starts_with(matcher.same_as + ".");
      if (!is_it || earlier.size != here.size || earlier.reverse != here.reverse) continue;
      MatchExplanation& match = here.of[i];
      if (there.pixel != match.pixel) continue;
      match.costs = there.costs;
      match.sums = there.sums;
      match.winner = there.winner;
      match.shift = there.shift;
      match.range = there.range;
    }
  }
}

}  // namespace xgm::explain
