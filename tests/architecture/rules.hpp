// SPDX-License-Identifier: Apache-2.0
// The rules of the house that a machine can see, checked on the text of the source files.
#pragma once

#include <optional>
#include <string>

#include "architecture/includes.hpp"
#include "architecture/tree.hpp"

namespace xgm::architecture {

/// Includes that point up or across: between rooms and between the folders of core (rooms.hpp),
/// from one plugin to another, into private folders, or to libraries that must stay inside.
Violations forbidden_includes(const Tree& tree);
/// Headers that include themselves by way of others.
Violations include_cycles(const Tree& tree);
/// Folders of rooms, plugins and applications whose files include each other, with the includes.
Violations folder_cycles(const Tree& tree);
/// Public headers that speak of a cv::Mat without saying of what it is (cv::Mat1f, cv::Mat1b ...).
Violations untyped_matrices(const Tree& tree);
/// Files that do not begin with the licence line.
Violations missing_licences(const Tree& tree);
/// Files of more than 400 lines.
Violations long_files(const Tree& tree);
/// Functions of more than 60 lines, from their first line to the brace that closes them.
Violations long_functions(const Tree& tree);

/// What is wrong with an include of a file in the folder that the name says; nothing if it may be.
using Complaint = std::optional<std::string>;
Complaint judge_in_framework(const std::string& file, const Include& include, const Tree& tree);
Complaint judge_in_plugins(const std::string& file, const Include& include, const Tree& tree);
Complaint judge_in_apps(const std::string& file, const Include& include, const Tree& tree);

}  // namespace xgm::architecture
