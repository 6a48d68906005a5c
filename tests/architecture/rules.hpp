// SPDX-License-Identifier: Apache-2.0
// The rules of the house that a machine can see, checked on the text of the source files.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace xgm::architecture {

/// Text of each file by its path from the top of the tree, with '/'.
using Tree = std::map<std::string, std::string>;
using Faults = std::vector<std::string>;

/// The sources below framework, plugins, apps and tests.
Tree read_tree(const std::string& top);

/// Includes that point up the list apps > pipeline.hpp, io > plugin > stage > data, config > base,
/// from one plugin to another, into private folders, or to libraries that must stay inside.
Faults forbidden_includes(const Tree& tree);
/// Headers that include themselves by way of others.
Faults include_cycles(const Tree& tree);
/// Files that do not begin with the licence line.
Faults missing_licences(const Tree& tree);
/// Files of more than 500 lines.
Faults long_files(const Tree& tree);

}  // namespace xgm::architecture
