// SPDX-License-Identifier: Apache-2.0
// YAML's merge key: '<<: *other' takes the entries of another map that this one does not have.
#pragma once

#include <vector>

#include "config/node.hpp"

namespace xgm {

inline constexpr const char* kMergeKey = "<<";

/// The maps that the value of a merge key names: itself, or the elements of a list. None if it is
/// anything else.
std::vector<Node> maps_to_merge(Node value);

/// Adds the entries of `other` whose keys `map` does not have.
void merge(Node& map, const Node& other);

}  // namespace xgm
