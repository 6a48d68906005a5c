// SPDX-License-Identifier: Apache-2.0
// Paths with a gap for the name of a scene: "{scene}/left.png".
#pragma once

#include <set>
#include <string>

namespace xgm::folder {

/// Whether the pattern has a gap.
bool has_gap(const std::string& pattern);

/// Whether it has another word in braces, such as "{scnee}".
bool has_unknown_placeholder(const std::string& pattern);

/// The pattern with `scene` in every gap, below `top` unless it is absolute; "" for "".
std::string fill(const std::string& pattern, const std::string& scene, const std::string& top);

/// All names that make the pattern, as far as its first part with a gap, a path that is there.
std::set<std::string> names_that_fit(const std::string& pattern, const std::string& top);

}  // namespace xgm::folder
