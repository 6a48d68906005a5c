// SPDX-License-Identifier: Apache-2.0
// Cycles in a directed graph.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace xgm::architecture {

/// For each node its successors, each with one reason for the arrow.
using Graph = std::map<std::string, std::map<std::string, std::string>>;
/// The nodes in order; the last has an arrow to the first.
using Cycle = std::vector<std::string>;

/// At least one cycle if there is any; once it is mended, the next may appear.
std::vector<Cycle> find_cycles(const Graph& graph);

}  // namespace xgm::architecture
