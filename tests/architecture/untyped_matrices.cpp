// SPDX-License-Identifier: Apache-2.0
#include <regex>
#include <sstream>

#include "architecture/rooms.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {

Violations untyped_matrices(const Tree& tree) {
  static const std::regex untyped(R"(\bcv::Mat\b)"), comment("//.*");
  Violations violations;
  for (const auto& [file, text] : tree) {
    if (!file.starts_with("framework/") || !place_of(file).is_public) continue;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (std::regex_search(std::regex_replace(line, comment, ""), untyped))
        violations.push_back(file + ":" + std::to_string(number) +
                             " has a cv::Mat without a type of elements");
    }
  }
  return violations;
}

}  // namespace xgm::architecture
