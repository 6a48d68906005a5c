// SPDX-License-Identifier: Apache-2.0
#include "config/merge_keys.hpp"

#include <algorithm>

namespace xgm {

std::vector<Node> maps_to_merge(Node value) {
  if (value.is_map()) return {std::move(value)};
  const bool are_maps = std::all_of(value.items.begin(), value.items.end(),
                                    [](const Node& item) { return item.is_map(); });
  return are_maps ? std::move(value.items) : std::vector<Node>();
}

void merge(Node& map, const Node& other) {
  Node lacking;  // a key that `other` has twice is twice in the result, and told
  for (const Entry& entry : other.entries) {
    if (map.find(entry.key) == nullptr) lacking.entries.push_back(entry);
  }
  map.entries.insert(map.entries.end(), lacking.entries.begin(), lacking.entries.end());
}

}  // namespace xgm
