// SPDX-License-Identifier: Apache-2.0
#include "terminal/observer.hpp"

#include <spdlog/fmt/fmt.h>

#include "terminal/console.hpp"

namespace xgm::cli {

void TerminalObserver::log(LogLevel level, const StagePlace& place, const std::string& text) {
  const std::string line = place.path + (place.path.empty() ? "" : ": ") + text;
  if (level == LogLevel::debug) {
    log_debug(line);
  } else if (level == LogLevel::info) {
    log_info(line);
  } else {
    log_warning(line);
  }
}

void TerminalObserver::stage_begin(const StagePlace& place) {
  progress_.stage(place.path + " (" + place.plugin + ")");
}

void TerminalObserver::stage_same_as(const StagePlace& place, const std::string& earlier) {
  log_debug(place.path + ": found by " + earlier);
}

void TerminalObserver::stage_end(const StagePlace& place, const StageStatistics& statistics,
                                 const Artifact&) {
  log_debug(fmt::format("{}: {:.3f} s, {:.1f} MB", place.path, statistics.seconds,
                        static_cast<double>(statistics.bytes) / 1e6));
}

void TerminalObserver::figure(const StagePlace& place, const std::string& name, double value) {
  log_debug(fmt::format("{}: {} = {:.6g}", place.path, name, value));
}

void show_notes(const SceneInputs& inputs) {
  for (const std::string& note : inputs.scene.notes) log_info(note);
  for (const std::string& warning : inputs.warnings) log_warning(warning);
}

}  // namespace xgm::cli
