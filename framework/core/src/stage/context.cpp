// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/context.hpp"

#include <chrono>

#include "stage/misbehaviour.hpp"
#include "xgm/base/error.hpp"
#include "xgm/data/interval_mapping.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {
namespace {

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

std::size_t size_of(const Image& image) {
  return static_cast<std::size_t>(image.size().area()) *
         (image.planes.size() * sizeof(float) + (image.valid.empty() ? 0 : 1));
}

}  // namespace

const RunFacts Context::kNoFacts;

Stage::~Stage() = default;
Observer::~Observer() = default;
void Observer::log(LogLevel, const StagePlace&, const std::string&) {}
void Observer::stage_begin(const StagePlace&) {}
void Observer::stage_end(const StagePlace&, const StageStatistics&, const Artifact&) {}
void Observer::figure(const StagePlace&, const std::string&, double) {}
void Observer::progress(double) {}
void Observer::stage_input(const StagePlace&, const Artifact&) {}
void Observer::stage_same_as(const StagePlace&, const std::string&) {}

Context Context::with(const RunFacts& facts) const {
  Context inner = *this;
  inner.facts_ = &facts;
  return inner;
}

Context Context::scope(std::string_view name) const {
  Context inner = *this;
  std::string& path = inner.place_.path;
  if (!path.empty()) path += '.';
  path += name;
  return inner;
}

Context Context::level(std::string_view name, double scale) const {
  Context inner = scope(name);
  inner.place_.level = {std::string(name), place_.level.scale * scale, inner.path()};
  for (std::optional<Interval>* searched : {&inner.searched_, &inner.searched_by_other_}) {
    if (*searched) *searched = divided(**searched, scale);
  }
  return inner;
}

Context Context::other_view(std::string_view name) const {
  Context inner = scope(name);
  inner.place_.view = place_.view == View::forward ? View::reverse : View::forward;
  std::swap(inner.searched_, inner.searched_by_other_);
  return inner;
}

Context Context::part(double begin, double end) const {
  Context inner = *this;
  inner.begin_ = begin_ + (end_ - begin_) * begin;
  inner.end_ = begin_ + (end_ - begin_) * end;
  return inner;
}

Context Context::asking(AskedOnce& once) const {
  Context inner = *this;
  inner.asked_once_ = &once;
  return inner;
}

Context Context::inside(std::string_view field, std::string_view kind, const std::string& plugin,
                        const Stage& stage) const {
  Context inner = scope(field);
  inner.place_.depth = place_.stage == nullptr ? 0 : place_.depth + 1;
  inner.place_.slot = field;
  inner.place_.kind = kind;
  inner.place_.plugin = plugin;
  inner.place_.stage = &stage;
  return inner;
}

void Context::take_view(const MatchRequest& request) {
  take_view(request.pair);
  searched_ = request.range.hull();
  searched_by_other_ =
      request.reverse_range ? request.reverse_range->hull() : reversed(request.range.hull());
}

void Context::require_none(const std::optional<Fault>& fault) const {
  xgm::require_none(fault, place_);
}

void Context::log(LogLevel level, const std::string& text) const {
  if (observer_ != nullptr) observer_->log(level, place_, text);
}

void Context::tell_input(const Artifact& input) const {
  if (observer_ != nullptr) observer_->stage_input(place_, input);
}

void Context::figure(const std::string& name, double value) const {
  if (observer_ != nullptr) observer_->figure(place_, name, value);
}

void Context::same_as(const std::string& earlier) const {
  if (observer_ != nullptr) observer_->stage_same_as(place_, earlier);
}

void Context::throw_if_cancelled() const {
  if (cancelled()) throw Cancelled();
}

void Context::progress(double share) const {
  throw_if_cancelled();
  if (observer_ != nullptr) observer_->progress(begin_ + (end_ - begin_) * share);
}

Context::StageRun::StageRun(const Context& context) : context_(context), start_(now()) {
  context.throw_if_cancelled();
  if (context.observer_ != nullptr) context.observer_->stage_begin(context.place_);
}

void Context::StageRun::finish(const ImagePair& result) const {
  finish(size_of(result.base) + size_of(result.match), &result);
}
void Context::StageRun::finish(const DisparityRange& result) const {
  finish(result.bytes(), &result);
}
void Context::StageRun::finish(const CostVolume& result) const {
  finish(result.bytes() + result.shape().bytes(), &result);
}
void Context::StageRun::finish(const AggregatedVolume& result) const {
  finish(result.bytes(), &result);
}
void Context::StageRun::finish(const DisparityMap& result) const {
  finish(result.bytes(), &result);
}
void Context::StageRun::finish(const MatchResult& result) const {
  finish(result.forward.bytes() + (result.reverse ? result.reverse->bytes() : 0), &result);
}

void Context::StageRun::finish(const cv::Mat1f& result) const {
  finish(result.total() * sizeof(float), &result);
}

void Context::StageRun::finish(std::size_t bytes, const Artifact& result) const {
  context_.throw_if_cancelled();
  if (context_.observer_ == nullptr) return;
  context_.observer_->stage_end(context_.place_, {now() - start_, bytes}, result);
  context_.progress(1);
}

void Context::StageRun::rethrow() const { rethrow_as_error(context_.place_); }

}  // namespace xgm
