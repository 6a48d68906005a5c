// SPDX-License-Identifier: Apache-2.0
// Forests and the files that hold them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm::forest {

/// A question: is the feature above the threshold? Children below `inner` of the tree are nodes,
/// the others leaves.
struct Node {
  std::uint8_t feature, threshold;
  std::uint16_t if_not, if_so;
};

/// Node 0 is the root, or the only leaf if there are no nodes. A tree of n nodes has n + 1 leaves.
struct Tree {
  std::vector<Node> nodes;           ///< children come after their parents
  std::vector<std::uint8_t> scores;  ///< `matchers` of each leaf
};

struct Forest {
  int feature_version = 0;
  int matchers = 0, costs = 0, features = 0;
  std::vector<Tree> trees;
};

/// Reads a forest:
///
///   xgm forest 1
///   # any number of comments
///   features VERSION MATCHERS COSTS FEATURES
///   trees COUNT
///
/// ended by line feeds, then each tree: the number n of its nodes (two bytes, the lower one first);
/// n nodes: feature, threshold, if_not, if_so (1, 1, 2 and 2 bytes); n + 1 leaves of MATCHERS
/// bytes. Throws Error, which names `path` and the line or byte, if anything else is in the file.
Forest read_forest(const std::string& path);

/// The same from memory; `path` is for messages.
XGM_API Forest parse_forest(std::string_view bytes, const std::string& path);

}  // namespace xgm::forest
