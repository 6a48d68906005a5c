// SPDX-License-Identifier: Apache-2.0
// Small text files that stand beside images, and numbers in them, read strictly.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace xgm::dataset {

struct Line {
  std::string place;  ///< "folder/calib.txt:3", for messages
  std::string text;   ///< without the spaces around it
};

/// The lines that are not empty, of which there is at least one. A byte order mark is left out.
/// Throws Error if the file is missing, unreadable, empty, no plain text or far too large.
std::vector<Line> read_lines(const std::string& file);

std::string_view trimmed(std::string_view text);

/// The number that is all of `text`. Throws Error that begins with `place` and `what`.
double to_number(std::string_view text, const std::string& place, const std::string& what);
/// All numbers of a text, separated by spaces. Throws Error likewise.
std::vector<double> to_numbers(std::string_view text, const std::string& place,
                               const std::string& what);

}  // namespace xgm::dataset
