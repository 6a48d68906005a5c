// SPDX-License-Identifier: Apache-2.0
// What a stage knows of the run it is in: where it stands, and whom to tell.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "xgm/base/export.hpp"
#include "xgm/data/fault.hpp"
#include "xgm/stage/observer.hpp"
#include "xgm/stage/place.hpp"
#include "xgm/stage/run_facts.hpp"

namespace xgm {

class AskedOnce;  // xgm/stage/asked_once.hpp

/// Passed to every stage. Cheap to copy; scopes, levels, views and parts are made for the stages
/// inside.
class XGM_API Context {
 public:
  /// Outermost context. Without an observer nothing is told to anyone.
  Context() = default;
  /// `observer` may be null; `stop` is that of RunOptions. `base_is_reverse`: whether the base
  /// image of the run is the match image of its pair.
  explicit Context(Observer* observer, std::stop_token stop = {}, bool base_is_reverse = false)
      : observer_(observer), stop_(std::move(stop)), base_is_reverse_(base_is_reverse) {}
  /// The same with facts of the run, which outlive all contexts that are made of this one.
  Context with(const RunFacts& facts) const;

  /// The context of something inside this stage that is neither a level nor a view.
  Context scope(std::string_view name) const;
  /// The context of a level of a pyramid, whose images are `scale` times smaller than this stage's.
  Context level(std::string_view name, double scale) const;
  /// The context of what is done for the other view. Stages that are given an image pair find their
  /// view themselves; this is for those that are given maps or ranges alone.
  Context other_view(std::string_view name = "reverse") const;
  /// The share [begin, end) of this stage's work, 0 to 1.
  Context part(double begin, double end) const;
  /// The context of matchers whose answers `once` may know.
  Context asking(AskedOnce& once) const;

  const StagePlace& place() const { return place_; }
  const std::string& path() const { return place_.path; }
  const RunFacts& run() const { return *facts_; }
  AskedOnce* asked_once() const { return asked_once_; }  ///< null if there is none

  void debug(const std::string& text) const { log(LogLevel::debug, text); }
  void info(const std::string& text) const { log(LogLevel::info, text); }
  void warn(const std::string& text) const { log(LogLevel::warning, text); }
  /// Tells a figure for the run's record.
  void figure(const std::string& name, double value) const;
  /// The disparities that the matcher around searches in the view of this stage, px of its level;
  /// no matched disparity lies outside of them. None if there is no run.
  std::optional<Interval> searched() const { return searched_; }

  /// Share of this stage's own work that is done, 0 to 1. Throws Cancelled if the run is.
  void progress(double share) const;

  /// Whether the run is to end. Loops of xgm/base/parallel.hpp, progress() and the beginning and
  /// end of stages look by themselves; what else may take more than some hundredths of a second
  /// calls one of these in between. Any thread may.
  bool cancelled() const { return stop_.stop_requested(); }
  void throw_if_cancelled() const;

  /// Used by slots: the context of the stage in `field`.
  Context inside(std::string_view field, std::string_view kind, const std::string& plugin,
                 const Stage& stage) const;

  /// Used by slots: an input of the stage that runs here. A pair tells which view it works on, a
  /// request what is searched, too.
  void take_view(const ImagePair& pair) { place_.view = view_of(pair); }
  void take_view(const MatchRequest& request);
  template <class Other>
  void take_view(const Other&) {}

  /// Used by slots: tells the observer of an input of the stage that runs here.
  template <class Input>
  void show_input(const Input& input) const {
    if constexpr (std::is_constructible_v<Artifact, const Input*>) {
      tell_input(&input);
    } else if constexpr (requires { input.each([](const auto&) {}); }) {
      input.each([this](const auto& part) { tell_input(&part); });
    }
  }

  /// Used by AskedOnce: the stage that runs here is given what was found at the path `earlier`.
  void same_as(const std::string& earlier) const;

  /// Used by slots: what is wrong with the result of the stage that runs here. Throws Error if
  /// anything is.
  void require_none(const std::optional<Fault>& fault) const;

  /// Used by slots: runs `body` as the stage at this place, timed and told to the observer; adds
  /// the path to what it throws. Throws Cancelled, and tells of no end, if the run is cancelled.
  template <class Body>
  auto run_stage(Body body) const {
    const StageRun run(*this);
    try {
      auto result = body(*this);
      run.finish(result);
      return result;
    } catch (...) {
      run.rethrow();
    }
  }

 private:
  class XGM_API StageRun {
   public:
    explicit StageRun(const Context& context);
    void finish(const ImagePair& result) const;
    void finish(const DisparityRange& result) const;
    void finish(const CostVolume& result) const;
    void finish(const AggregatedVolume& result) const;
    void finish(const DisparityMap& result) const;
    void finish(const MatchResult& result) const;
    void finish(const cv::Mat1f& result) const;
    template <class Other>
    void finish(const Other&) const {
      finish(0, {});
    }
    [[noreturn]] void rethrow() const;

   private:
    void finish(std::size_t bytes, const Artifact& result) const;
    const Context& context_;
    double start_;
  };

  View view_of(const ImagePair& pair) const {
    return pair.is_reverse == base_is_reverse_ ? View::forward : View::reverse;
  }
  void log(LogLevel level, const std::string& text) const;
  void tell_input(const Artifact& input) const;

  static const RunFacts kNoFacts;

  Observer* observer_ = nullptr;
  const RunFacts* facts_ = &kNoFacts;
  AskedOnce* asked_once_ = nullptr;
  std::stop_token stop_;
  bool base_is_reverse_ = false;
  StagePlace place_;
  std::optional<Interval> searched_, searched_by_other_;  ///< in this view and in the other one
  double begin_ = 0, end_ = 1;
};

}  // namespace xgm
