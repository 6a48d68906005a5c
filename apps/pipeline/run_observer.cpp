// SPDX-License-Identifier: Apache-2.0
#include "run_observer.hpp"

#include <spdlog/spdlog.h>

namespace xgm::cli {

void RunObserver::log(LogLevel level, const StagePlace& place, const std::string& text) {
  RunRecorder::log(level, place, text);
  const auto shown = level == LogLevel::debug  ? spdlog::level::debug
                     : level == LogLevel::info ? spdlog::level::info
                                               : spdlog::level::warn;
  spdlog::log(shown, "{}{}{}", place.path, place.path.empty() ? "" : ": ", text);
}

void RunObserver::stage_begin(const StagePlace& place) {
  RunRecorder::stage_begin(place);
  progress_.stage(place.path + " (" + place.plugin + ")");
  for (Observer* other : others_) other->stage_begin(place);
}

void RunObserver::stage_end(const StagePlace& place, const StageStatistics& statistics,
                            const Artifact& result) {
  RunRecorder::stage_end(place, statistics, result);
  spdlog::debug("{}: {:.3f} s, {:.1f} MB", place.path, statistics.seconds,
                static_cast<double>(statistics.bytes) / 1e6);
  if (dumper_.wants(place.path)) dumper_.write(place.path, result);
  for (Observer* other : others_) other->stage_end(place, statistics, result);
}

void RunObserver::stage_input(const StagePlace& place, const Artifact& input) {
  for (Observer* other : others_) other->stage_input(place, input);
}

void RunObserver::figure(const StagePlace& place, const std::string& name, double value) {
  RunRecorder::figure(place, name, value);
  spdlog::debug("{}: {} = {:.6g}", place.path, name, value);
  for (Observer* other : others_) other->figure(place, name, value);
}

}  // namespace xgm::cli
