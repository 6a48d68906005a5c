// SPDX-License-Identifier: Apache-2.0
#include "terminal/observer.hpp"

#include <spdlog/spdlog.h>

namespace xgm::cli {

void TerminalObserver::log(LogLevel level, const std::string& stage_path, const std::string& text) {
  const auto shown = level == LogLevel::debug  ? spdlog::level::debug
                     : level == LogLevel::info ? spdlog::level::info
                                               : spdlog::level::warn;
  spdlog::log(shown, "{}{}{}", stage_path, stage_path.empty() ? "" : ": ", text);
}

void TerminalObserver::stage_begin(const std::string& stage_path, const std::string& plugin) {
  progress_.stage(stage_path + " (" + plugin + ")");
}

void TerminalObserver::stage_end(const std::string& stage_path, const StageStatistics& statistics,
                                 const Artifact&) {
  spdlog::debug("{}: {:.3f} s, {:.1f} MB", stage_path, statistics.seconds,
                static_cast<double>(statistics.bytes) / 1e6);
}

void TerminalObserver::report(const std::string& stage_path, const std::string& name,
                              double value) {
  spdlog::debug("{}: {} = {:.6g}", stage_path, name, value);
}

void show_notes(const SceneInputs& inputs) {
  for (const std::string& note : inputs.scene.notes) spdlog::info(note);
  for (const std::string& warning : inputs.warnings) spdlog::warn(warning);
}

}  // namespace xgm::cli
