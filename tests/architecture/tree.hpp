// SPDX-License-Identifier: Apache-2.0
// The sources of the project as text, which all rules of tests/architecture read.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace xgm::architecture {

/// Text of each file by its path from the top of the tree, with '/'.
using Tree = std::map<std::string, std::string>;
/// One sentence for each place that breaks a rule. Empty: the rule is kept.
using Violations = std::vector<std::string>;

/// The sources below framework, plugins, apps and tests.
Tree read_tree(const std::string& top);

/// The parts of a path.
std::vector<std::string> split_path(std::string_view path);

/// Whether a file of the tree lies in this folder ("a/b") or below it.
bool has_folder(const Tree& tree, const std::string& folder);

}  // namespace xgm::architecture
