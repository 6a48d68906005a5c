// SPDX-License-Identifier: Apache-2.0
#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

Complaint judge(const std::string& file, const Include& include, const Tree& tree) {
  if (file.starts_with("framework/")) return judge_in_framework(file, include, tree);
  if (file.starts_with("plugins/")) return judge_in_plugins(file, include, tree);
  if (file.starts_with("apps/")) return judge_in_apps(file, include, tree);
  return {};
}

}  // namespace

Violations forbidden_includes(const Tree& tree) {
  Violations violations;
  for (const auto& [file, text] : tree)
    for (const Include& include : includes_of(text))
      if (const Complaint complaint = judge(file, include, tree))
        violations.push_back(file + " includes " + include.target + ": " + *complaint);
  return violations;
}

}  // namespace xgm::architecture
