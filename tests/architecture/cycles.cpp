// SPDX-License-Identifier: Apache-2.0
#include "architecture/cycles.hpp"

#include <algorithm>
#include <set>

namespace xgm::architecture {
namespace {

/// Depth-first walk; a node met again while it is still open closes a cycle.
class Walk {
 public:
  explicit Walk(const Graph& graph) : graph_(graph) {}

  std::vector<Cycle> run() {
    for (const auto& [node, arrows] : graph_) visit(node);
    return cycles_;
  }

 private:
  void visit(const std::string& node) {
    const auto open = std::find(open_.begin(), open_.end(), node);
    if (open != open_.end()) cycles_.emplace_back(open, open_.end());
    if (!seen_.insert(node).second) return;
    open_.push_back(node);
    if (const auto found = graph_.find(node); found != graph_.end())
      for (const auto& [successor, reason] : found->second) visit(successor);
    open_.pop_back();
  }

  const Graph& graph_;
  std::vector<std::string> open_;
  std::set<std::string> seen_;
  std::vector<Cycle> cycles_;
};

}  // namespace

std::vector<Cycle> find_cycles(const Graph& graph) { return Walk(graph).run(); }

}  // namespace xgm::architecture
