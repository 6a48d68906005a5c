// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/segments.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/filter/plane_filling/edges.hpp"

namespace xgm::plane_filling {
namespace {

/// Disjoint sets of pixels; what is asked of a root lies beside its parent, in one cache line.
class Sets {
 public:
  Sets(std::size_t n, double scale) : nodes_(n), scale_(scale) {
    for (std::size_t i = 0; i < n; ++i) {
      nodes_[i] = {static_cast<std::uint32_t>(i), 1, 0, static_cast<float>(scale)};
    }
  }
  std::size_t root(std::size_t i) {
    while (nodes_[i].parent != i) {
      nodes_[i].parent = nodes_[nodes_[i].parent].parent;  // path halving keeps the trees flat
      i = nodes_[i].parent;
    }
    return i;
  }
  /// Two different roots.
  void join(std::size_t a, std::size_t b, float weight) {
    if (nodes_[a].size < nodes_[b].size) std::swap(a, b);
    Node &whole = nodes_[a], &part = nodes_[b];
    part.parent = static_cast<std::uint32_t>(a);
    whole.size += part.size;
    whole.inner = std::max({whole.inner, part.inner, weight});
    whole.limit = whole.inner + static_cast<float>(scale_ / whole.size);
  }
  int size(std::size_t root) const { return nodes_[root].size; }
  /// The largest difference by which a neighbour may be joined.
  float limit(std::size_t root) const { return nodes_[root].limit; }
  void fetch(std::size_t i) const { __builtin_prefetch(&nodes_[i]); }

 private:
  struct Node {
    std::uint32_t parent;
    int size;
    float inner;  ///< largest difference that joined the segment
    float limit;
  };
  std::vector<Node> nodes_;
  double scale_;
};

/// Joins the sets at the ends of each edge, one after the other, where that is `wanted`. Returns
/// the edges where it was not.
template <class Wanted>
std::vector<Edge> join_where(const std::vector<Edge>& edges, std::size_t width, Sets& sets,
                             const Wanted& wanted) {
  constexpr std::size_t kAhead = 16;  // edges, so that their pixels are in the cache in time
  const auto end_of = [&](const Edge& edge) { return edge.begin + (edge.is_down ? width : 1); };
  std::vector<Edge> left;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + kAhead < edges.size()) {
      sets.fetch(edges[i + kAhead].begin);
      if (edges[i + kAhead].is_down) sets.fetch(end_of(edges[i + kAhead]));
    }
    const Edge& edge = edges[i];
    const std::size_t a = sets.root(edge.begin), b = sets.root(end_of(edge));
    if (a == b) continue;
    if (wanted(a, b, edge.weight())) {
      sets.join(a, b, edge.weight());
    } else {
      left.push_back(edge);
    }
  }
  return left;
}

Segments numbered(Sets& sets, const Image& image) {
  const cv::Size size = image.size();
  Segments segments{cv::Mat1i(size, -1), 0};
  std::vector<int> label_of(image.planes.front().total(), -1);
  std::size_t i = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x, ++i) {
      if (!image.is_valid(y, x)) continue;
      int& label = label_of[sets.root(i)];
      if (label < 0) label = segments.count++;
      segments.label(y, x) = label;
    }
  }
  return segments;
}

}  // namespace

Segments find_segments(const DisparityMap& map, const Image& image, const SegmentRules& rules) {
  const auto width = static_cast<std::size_t>(map.size().width);
  Sets sets(map.disparity.total(), rules.scale);
  // Edges within one segment stay within it: small segments need only those between segments.
  const std::vector<Edge> between =
      join_where(sorted_edges(map, image, rules.jump), width, sets,
                 [&](std::size_t a, std::size_t b, float weight) {
                   return weight <= std::min(sets.limit(a), sets.limit(b));
                 });
  join_where(between, width, sets, [&](std::size_t a, std::size_t b, float) {
    return std::min(sets.size(a), sets.size(b)) < rules.min_size;
  });
  return numbered(sets, image);
}

}  // namespace xgm::plane_filling
