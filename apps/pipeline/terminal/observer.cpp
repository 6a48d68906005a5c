// SPDX-License-Identifier: Apache-2.0
#include "terminal/observer.hpp"

#include <spdlog/spdlog.h>

namespace xgm::cli {

void TerminalObserver::log(LogLevel level, const StagePlace& place, const std::string& text) {
  const auto shown = level == LogLevel::debug  ? spdlog::level::debug
                     : level == LogLevel::info ? spdlog::level::info
                                               : spdlog::level::warn;
  spdlog::log(shown, "{}{}{}", place.path, place.path.empty() ? "" : ": ", text);
}

void TerminalObserver::stage_begin(const StagePlace& place) {
  progress_.stage(place.path + " (" + place.plugin + ")");
}

void TerminalObserver::stage_end(const StagePlace& place, const StageStatistics& statistics,
                                 const Artifact&) {
  spdlog::debug("{}: {:.3f} s, {:.1f} MB", place.path, statistics.seconds,
                static_cast<double>(statistics.bytes) / 1e6);
}

void TerminalObserver::figure(const StagePlace& place, const std::string& name, double value) {
  spdlog::debug("{}: {} = {:.6g}", place.path, name, value);
}

void show_notes(const SceneInputs& inputs) {
  for (const std::string& note : inputs.scene.notes) spdlog::info(note);
  for (const std::string& warning : inputs.warnings) spdlog::warn(warning);
}

}  // namespace xgm::cli
