// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/observers.hpp"

namespace xgm {

void Observers::log(LogLevel level, const StagePlace& place, const std::string& text) {
  for (Observer* observer : observers_) observer->log(level, place, text);
}

void Observers::stage_begin(const StagePlace& place) {
  for (Observer* observer : observers_) observer->stage_begin(place);
}

void Observers::stage_input(const StagePlace& place, const Artifact& input) {
  for (Observer* observer : observers_) observer->stage_input(place, input);
}

void Observers::stage_same_as(const StagePlace& place, const std::string& earlier) {
  for (Observer* observer : observers_) observer->stage_same_as(place, earlier);
}

void Observers::stage_end(const StagePlace& place, const StageStatistics& statistics,
                          const Artifact& result) {
  for (Observer* observer : observers_) observer->stage_end(place, statistics, result);
}

void Observers::figure(const StagePlace& place, const std::string& name, double value) {
  for (Observer* observer : observers_) observer->figure(place, name, value);
}

void Observers::progress(double share) {
  for (Observer* observer : observers_) observer->progress(share);
}

}  // namespace xgm
