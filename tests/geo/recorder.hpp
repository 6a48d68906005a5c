// SPDX-License-Identifier: Apache-2.0
// What a stage says of itself.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "xgm/stage/observer.hpp"

namespace xgm::testing {

class Recorder final : public Observer {
 public:
  void log(LogLevel level, const StagePlace&, const std::string& text) override {
    if (level == LogLevel::warning) warnings.push_back(text);
  }
  void figure(const StagePlace&, const std::string& name, double value) override {
    figures[name] = value;
  }
  /// Whether a warning holds this text.
  bool warned(const std::string& part) const {
    for (const std::string& text : warnings) {
      if (text.find(part) != std::string::npos) return true;
    }
    return false;
  }

  std::vector<std::string> warnings;
  std::map<std::string, double> figures;
};

}  // namespace xgm::testing
