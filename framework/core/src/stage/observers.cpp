// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/observers.hpp"

namespace xgm {

void Observers::log(LogLevel level, const std::string& stage_path, const std::string& text) {
  for (Observer* observer : observers_) observer->log(level, stage_path, text);
}

void Observers::stage_begin(const std::string& stage_path, const std::string& plugin) {
  for (Observer* observer : observers_) observer->stage_begin(stage_path, plugin);
}

void Observers::stage_input(const std::string& stage_path, const Artifact& input) {
  for (Observer* observer : observers_) observer->stage_input(stage_path, input);
}

void Observers::stage_end(const std::string& stage_path, const StageStatistics& statistics,
                          const Artifact& result) {
  for (Observer* observer : observers_) observer->stage_end(stage_path, statistics, result);
}

void Observers::report(const std::string& stage_path, const std::string& name, double value) {
  for (Observer* observer : observers_) observer->report(stage_path, name, value);
}

void Observers::progress(double share) {
  for (Observer* observer : observers_) observer->progress(share);
}

}  // namespace xgm
