// SPDX-License-Identifier: Apache-2.0
#include "run_observer.hpp"

#include <spdlog/spdlog.h>

namespace xgm::cli {

void RunObserver::log(LogLevel level, const std::string& stage_path, const std::string& text) {
  RunRecorder::log(level, stage_path, text);
  const auto shown = level == LogLevel::debug  ? spdlog::level::debug
                     : level == LogLevel::info ? spdlog::level::info
                                               : spdlog::level::warn;
  spdlog::log(shown, "{}{}{}", stage_path, stage_path.empty() ? "" : ": ", text);
}

void RunObserver::stage_begin(const std::string& stage_path, const std::string& plugin) {
  RunRecorder::stage_begin(stage_path, plugin);
  progress_.stage(stage_path + " (" + plugin + ")");
  for (Observer* other : others_) other->stage_begin(stage_path, plugin);
}

void RunObserver::stage_end(const std::string& stage_path, const StageStatistics& statistics,
                            const Artifact& result) {
  RunRecorder::stage_end(stage_path, statistics, result);
  spdlog::debug("{}: {:.3f} s, {:.1f} MB", stage_path, statistics.seconds,
                static_cast<double>(statistics.bytes) / 1e6);
  if (dumper_.wants(stage_path)) dumper_.write(stage_path, result);
  for (Observer* other : others_) other->stage_end(stage_path, statistics, result);
}

void RunObserver::stage_input(const std::string& stage_path, const Artifact& input) {
  for (Observer* other : others_) other->stage_input(stage_path, input);
}

void RunObserver::report(const std::string& stage_path, const std::string& name, double value) {
  RunRecorder::report(stage_path, name, value);
  spdlog::debug("{}: {} = {:.6g}", stage_path, name, value);
  for (Observer* other : others_) other->report(stage_path, name, value);
}

}  // namespace xgm::cli
