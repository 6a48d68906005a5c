// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/asked_once.hpp"

#include <algorithm>

namespace xgm {
namespace {

/// Whether they share their pixels, which are not compared.
bool is_same(const cv::Mat& a, const cv::Mat& b) {
  return a.data == b.data && a.size() == b.size();
}

bool is_same(const Image& a, const Image& b) {
  return std::equal(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(),
                    [](const cv::Mat1f& p, const cv::Mat1f& q) { return is_same(p, q); }) &&
         is_same(a.valid, b.valid);
}

bool is_same(const ImagePair& a, const ImagePair& b) {
  return is_same(a.base, b.base) && is_same(a.match, b.match) && a.is_reverse == b.is_reverse;
}

bool is_same(const DisparityRange& a, const DisparityRange& b) {
  return a.size() == b.size() && a.hull() == b.hull() && a.data() == b.data();
}

bool is_same(const std::optional<DisparityRange>& a, const std::optional<DisparityRange>& b) {
  return a && b ? is_same(*a, *b) : !a && !b;
}

/// Matchers of a single view are asked nothing of the other one.
bool is_same(const MatchRequest& a, const MatchRequest& b, const Matcher& matcher) {
  return !a.part && !b.part && is_same(a.pair, b.pair) && is_same(a.range, b.range) &&
         (!matcher.gives_reverse_map() || is_same(a.reverse_range, b.reverse_range));
}

/// None if only a search through a range map would tell what the other view is asked.
std::optional<MatchRequest> of_other_view(const MatchRequest& request) {
  if (!request.reverse_range && !request.range.is_uniform()) return std::nullopt;
  return MatchRequest{request.pair.swapped(),
                      request.reverse_range ? *request.reverse_range : request.range.reversed(),
                      request.range};
}

MatchResult clone(const MatchResult& result) {
  MatchResult copy{result.forward.clone(), std::nullopt};
  if (result.reverse) copy.reverse = result.reverse->clone();
  return copy;
}

}  // namespace

MatchResult Matcher::answer(const Matcher& matcher, const MatchRequest& request,
                            const Context& context) {
  AskedOnce* const once = context.asked_once();
  return once != nullptr ? once->answer(matcher, request, context) : matcher.run(request, context);
}

AskedOnce::AskedOnce(const MatchRequest& request, const SlotList<Matcher>& members)
    : request_(request), of_other_view_(of_other_view(request)) {
  for (const auto& member : members) {
    for (const Stage* matcher : member.matchers()) ++uses_[matcher];
  }
  std::erase_if(uses_, [](const auto& use) { return use.second < 2; });
}

MatchResult AskedOnce::ask(const Slot<Matcher>& member, const Context& context) {
  MatchResult result = member(uses_.empty() ? context : context.asking(*this), request_);
  forget(member);
  return result;
}

MatchResult AskedOnce::answer(const Matcher& matcher, const MatchRequest& request,
                              const Context& context) {
  const auto use = uses_.find(&matcher);
  if (use == uses_.end()) return matcher.run(request, context);
  const std::optional<bool> other_view = other_view_asked(matcher, request);
  if (!other_view) return matcher.run(request, context);

  const bool is_last = use->second == 1;
  const std::pair<const Stage*, bool> key(&matcher, *other_view);
  const auto kept = kept_.find(key);
  if (kept == kept_.end()) {
    MatchResult result = matcher.run(request, context);
    if (!is_last) kept_.emplace(key, Answer{context.path(), clone(result)});
    return result;
  }
  context.same_as(kept->second.path);
  if (!is_last) return clone(kept->second.result);
  MatchResult result = std::move(kept->second.result);
  kept_.erase(kept);
  return result;
}

std::optional<bool> AskedOnce::other_view_asked(const Matcher& matcher,
                                                const MatchRequest& request) const {
  if (is_same(request, request_, matcher)) return false;
  if (of_other_view_ && is_same(request, *of_other_view_, matcher)) return true;
  return std::nullopt;
}

void AskedOnce::forget(const Slot<Matcher>& member) {
  for (const Stage* matcher : member.matchers()) {
    const auto use = uses_.find(matcher);
    if (use == uses_.end() || --use->second > 0) continue;
    kept_.erase({matcher, false});
    kept_.erase({matcher, true});
    uses_.erase(use);
  }
}

}  // namespace xgm
