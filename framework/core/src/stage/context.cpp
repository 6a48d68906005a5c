// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/context.hpp"

#include <chrono>
#include <new>

#include "xgm/base/error.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {
namespace {

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

std::size_t size_of(const DisparityRange& range) {
  return range.is_uniform() ? 0 : static_cast<std::size_t>(range.size().area()) * 2 * sizeof(int);
}

std::size_t size_of(const Image& image) {
  return static_cast<std::size_t>(image.size().area()) *
         (image.planes.size() * sizeof(float) + (image.valid.empty() ? 0 : 1));
}

}  // namespace

Stage::~Stage() = default;
Observer::~Observer() = default;
void Observer::log(LogLevel, const std::string&, const std::string&) {}
void Observer::stage_begin(const std::string&, const std::string&) {}
void Observer::stage_end(const std::string&, const StageStatistics&, const Artifact&) {}
void Observer::report(const std::string&, const std::string&, double) {}
void Observer::progress(double) {}
void Observer::stage_input(const std::string&, const Artifact&) {}

Context Context::scope(std::string_view name) const {
  Context inner = *this;
  if (!inner.path_.empty()) inner.path_ += '.';
  inner.path_ += name;
  return inner;
}

Context Context::part(double begin, double end) const {
  Context inner = *this;
  inner.begin_ = begin_ + (end_ - begin_) * begin;
  inner.end_ = begin_ + (end_ - begin_) * end;
  return inner;
}

void Context::log(LogLevel level, const std::string& text) const {
  if (observer_ != nullptr) observer_->log(level, path_, text);
}

void Context::tell_input(const Artifact& input) const {
  if (observer_ != nullptr) observer_->stage_input(path_, input);
}

void Context::report(const std::string& name, double value) const {
  if (observer_ != nullptr) observer_->report(path_, name, value);
}

void Context::throw_if_cancelled() const {
  if (cancelled()) throw Cancelled();
}

void Context::progress(double share) const {
  throw_if_cancelled();
  if (observer_ != nullptr) observer_->progress(begin_ + (end_ - begin_) * share);
}

Context::StageRun::StageRun(const Context& context, const std::string& plugin)
    : context_(context), start_(now()) {
  context.throw_if_cancelled();
  if (context.observer_ != nullptr) context.observer_->stage_begin(context.path_, plugin);
}

void Context::StageRun::finish(const ImagePair& result) const {
  finish(size_of(result.base) + size_of(result.match), &result);
}
void Context::StageRun::finish(const DisparityRange& result) const {
  finish(size_of(result), &result);
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

void Context::StageRun::finish(std::size_t bytes, const Artifact& result) const {
  context_.throw_if_cancelled();
  if (context_.observer_ == nullptr) return;
  context_.observer_->stage_end(context_.path_, {now() - start_, bytes}, result);
  context_.progress(1);
}

void Context::StageRun::rethrow() const {
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    if (!error.stage_path().empty()) throw;
    throw Error(context_.path_, error.message());
  } catch (const std::bad_alloc&) {
    throw Error(context_.path_,
                "not enough memory; use a smaller image, a narrower disparity range or a pyramid");
  } catch (const std::exception& error) {
    throw Error(context_.path_, error.what());
  }
}

}  // namespace xgm
