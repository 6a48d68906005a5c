// SPDX-License-Identifier: Apache-2.0
// What a stage knows of the run it is in: where it stands, and whom to tell.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/data/volume.hpp"

namespace xgm {

enum class LogLevel { debug, info, warning };

/// What a stage is given or has produced, shown to the observer while it lives.
using Artifact = std::variant<std::monostate, const ImagePair*, const DisparityRange*,
                              const CostVolume*, const AggregatedVolume*, const DisparityMap*,
                              const MatchResult*, const MatchRequest*>;

struct StageStatistics {
  double seconds = 0;     ///< wall time, stages inside included
  std::size_t bytes = 0;  ///< size of what the stage returned
};

/// Receives what happens in a run. All functions may be left as they are. Called from the thread
/// that runs the pipeline, never from several at once.
class XGM_API Observer {
 public:
  virtual ~Observer();
  virtual void log(LogLevel level, const std::string& stage_path, const std::string& text);
  virtual void stage_begin(const std::string& stage_path, const std::string& plugin);
  virtual void stage_end(const std::string& stage_path, const StageStatistics& statistics,
                         const Artifact& result);
  /// A figure that a stage found ("dy_before", 1.3), for the run's record.
  virtual void report(const std::string& stage_path, const std::string& name, double value);
  /// Share of the whole run that is done, 0 to 1, never falling.
  virtual void progress(double share);
  /// After stage_begin, once for each input that is an artifact, in the order of run's parameters.
  /// It lives until stage_end.
  virtual void stage_input(const std::string& stage_path, const Artifact& input);
};

/// Passed to every stage. Cheap to copy; scopes and parts are made for the stages inside.
class XGM_API Context {
 public:
  /// Outermost context. Without an observer nothing is told to anyone.
  Context() = default;
  explicit Context(Observer& observer) : observer_(&observer) {}
  /// `observer` may be null. `stop` is that of RunOptions.
  Context(Observer* observer, std::stop_token stop) : observer_(observer), stop_(std::move(stop)) {}

  /// The context of something inside this stage: a level, a view, a slot.
  Context scope(std::string_view name) const;
  /// The share [begin, end) of this stage's work, 0 to 1.
  Context part(double begin, double end) const;

  const std::string& path() const { return path_; }

  void debug(const std::string& text) const { log(LogLevel::debug, text); }
  void info(const std::string& text) const { log(LogLevel::info, text); }
  void warn(const std::string& text) const { log(LogLevel::warning, text); }
  void report(const std::string& name, double value) const;
  /// Share of this stage's own work that is done, 0 to 1. Throws Cancelled if the run is.
  void progress(double share) const;

  /// Whether the run is to end. Loops of xgm/base/parallel.hpp, progress() and the beginning and
  /// end of stages look by themselves; what else may take more than some hundredths of a second
  /// calls one of these in between. Any thread may.
  bool cancelled() const { return stop_.stop_requested(); }
  void throw_if_cancelled() const;

  /// Used by slots: tells the observer of an input of the stage that runs here.
  template <class Input>
  void show_input(const Input& input) const {
    if constexpr (std::is_constructible_v<Artifact, const Input*>) tell_input(&input);
  }

  /// Used by slots: runs `body` as the stage at this path, timed and told to the observer; adds the
  /// path to what it throws. Throws Cancelled, and tells of no end, if the run is cancelled.
  template <class Body>
  auto run_stage(const std::string& plugin, Body body) const {
    const StageRun run(*this, plugin);
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
    StageRun(const Context& context, const std::string& plugin);
    void finish(const ImagePair& result) const;
    void finish(const DisparityRange& result) const;
    void finish(const CostVolume& result) const;
    void finish(const AggregatedVolume& result) const;
    void finish(const DisparityMap& result) const;
    void finish(const MatchResult& result) const;
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

  void log(LogLevel level, const std::string& text) const;
  void tell_input(const Artifact& input) const;

  Observer* observer_ = nullptr;
  std::string path_;
  double begin_ = 0, end_ = 1;
  std::stop_token stop_;
};

}  // namespace xgm
