// SPDX-License-Identifier: Apache-2.0
#include "plugins/fuser/forest/votes.hpp"

#include <algorithm>
#include <array>

namespace xgm::forest {
namespace {

constexpr std::size_t kAbreast = 8;  // pixels whose steps do not wait for each other

/// The leaf that each of `count` pixels, kAbreast at most, comes to.
std::array<std::size_t, kAbreast> leaves(const Tree& tree, const std::uint8_t* features,
                                         std::size_t stride, std::size_t count) {
  std::array<std::size_t, kAbreast> at{};
  for (bool on_the_way = !tree.nodes.empty(); on_the_way;) {
    on_the_way = false;
    for (std::size_t i = 0; i < count; ++i) {
      if (at[i] >= tree.nodes.size()) continue;
      const Node& node = tree.nodes[at[i]];
      at[i] = features[i * stride + node.feature] > node.threshold ? node.if_so : node.if_not;
      on_the_way = true;
    }
  }
  for (std::size_t& leaf : at) leaf -= std::min(leaf, tree.nodes.size());
  return at;
}

}  // namespace

std::vector<int> votes(const Forest& forest, const std::vector<std::uint8_t>& features) {
  const auto stride = static_cast<std::size_t>(forest.features);
  const auto matchers = static_cast<std::size_t>(forest.matchers);
  const std::size_t pixels = features.size() / stride;
  std::vector<int> sums(pixels * matchers, 0);
  for (const Tree& tree : forest.trees) {
    for (std::size_t first = 0; first < pixels; first += kAbreast) {
      const std::size_t count = std::min(kAbreast, pixels - first);
      const auto at = leaves(tree, features.data() + first * stride, stride, count);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t m = 0; m < matchers; ++m) {
          sums[(first + i) * matchers + m] += tree.scores[at[i] * matchers + m];
        }
      }
    }
  }
  return sums;
}

}  // namespace xgm::forest
