// SPDX-License-Identifier: Apache-2.0
#include "architecture/cycles.hpp"
#include "architecture/rules.hpp"

namespace xgm::architecture {

Violations include_cycles(const Tree& tree) {
  Graph graph;
  for (const auto& [file, text] : tree)
    for (const Include& include : includes_of(text))
      if (const std::string target = resolve(file, include.target, tree); !target.empty())
        graph[file][target] = include.target;
  Violations violations;
  for (const Cycle& cycle : find_cycles(graph)) {
    std::string chain;
    for (const std::string& file : cycle) chain += file + " -> ";
    violations.push_back("include cycle: " + chain + cycle.front());
  }
  return violations;
}

}  // namespace xgm::architecture
