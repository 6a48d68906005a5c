// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

constexpr int kSteps = 255;  // of a grey level, by which differences are sorted: ties part badly
constexpr std::uint16_t kNotJoined = 256 * kSteps;

/// Image noise would part segments: means over 3x3 pixels, weighted by 1 2 1 in both directions.
Image smoothed(const Image& image) {
  Image smooth;
  smooth.valid = image.valid;
  const cv::Size size = image.size();
  for (const cv::Mat1f& plane : image.planes) {
    cv::Mat1f mean(size, 0.0F);
    parallel_for(0, size.height, [&](int y) {
      for (int x = 0; x < size.width; ++x) {
        float sum = 0, weights = 0;
        for (int v = std::max(0, y - 1); v <= std::min(size.height - 1, y + 1); ++v) {
          for (int u = std::max(0, x - 1); u <= std::min(size.width - 1, x + 1); ++u) {
            if (!image.is_valid(v, u)) continue;
            const auto weight = static_cast<float>((2 - std::abs(v - y)) * (2 - std::abs(u - x)));
            sum += weight * plane(v, u);
            weights += weight;
          }
        }
        if (weights > 0) mean(y, x) = sum / weights;
      }
    });
    smooth.planes.push_back(mean);
  }
  return smooth;
}

/// Each pixel has an edge to the right and one to the pixel below: numbers 2 * pixel and 2 * pixel
/// + 1.
class Graph {
 public:
  Graph(const DisparityMap& map, const Image& image, double jump)
      : map_(map), image_(image), jump_(jump), weight_(2 * map.disparity.total(), kNotJoined) {
    parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        const std::size_t edge = 2 * index({x, y});
        weight_[edge] = weight({x, y}, {x + 1, y});
        weight_[edge + 1] = weight({x, y}, {x, y + 1});
      }
    });
  }

  std::size_t index(cv::Point p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(map_.size().width) +
           static_cast<std::size_t>(p.x);
  }
  std::size_t end_of(std::size_t edge) const {
    return edge / 2 + (edge % 2 == 0 ? 1 : static_cast<std::size_t>(map_.size().width));
  }
  float weight(std::size_t edge) const { return static_cast<float>(weight_[edge]) / kSteps; }

  /// The numbers of the edges, ascending by weight, then by number; without those not to be joined.
  std::vector<std::uint32_t> sorted() const {
    std::vector<std::size_t> first(kNotJoined + 2, 0);
    for (const std::uint16_t w : weight_) ++first[w + std::size_t{1}];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> order(first[kNotJoined]);
    for (std::size_t edge = 0; edge < weight_.size(); ++edge) {
      if (weight_[edge] == kNotJoined) continue;
      order[first[weight_[edge]]++] = static_cast<std::uint32_t>(edge);
    }
    return order;
  }

 private:
  std::uint16_t weight(cv::Point a, cv::Point b) const {
    if (b.x >= map_.size().width || b.y >= map_.size().height) return kNotJoined;
    if (!image_.is_valid(a.y, a.x) || !image_.is_valid(b.y, b.x)) return kNotJoined;
    // Comparisons with NaN are false.
    if (std::abs(map_.disparity(a) - map_.disparity(b)) > static_cast<float>(jump_))
      return kNotJoined;
    const float steps = kSteps * colour_distance(image_, a, b);
    return static_cast<std::uint16_t>(std::min(steps, static_cast<float>(kNotJoined - 1)));
  }

  const DisparityMap& map_;
  const Image& image_;
  double jump_;
  std::vector<std::uint16_t> weight_;
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n), size_(n, 1), inner_(n, 0.0F) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];  // path halving keeps the trees flat
      i = parent_[i];
    }
    return i;
  }
  /// Two different roots.
  void join(std::size_t a, std::size_t b, float weight) {
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = static_cast<std::uint32_t>(a);
    size_[a] += size_[b];
    inner_[a] = std::max({inner_[a], inner_[b], weight});
  }
  int size(std::size_t root) const { return size_[root]; }
  /// The largest difference by which a neighbour may be joined.
  float limit(std::size_t root, double scale) const {
    return inner_[root] + static_cast<float>(scale / size_[root]);
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<int> size_;
  std::vector<float> inner_;  ///< largest difference that joined the segment
};

Segments numbered(DisjointSets& sets, const Image& image) {
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

float colour_distance(const Image& image, cv::Point a, cv::Point b) {
  float sum = 0;
  for (const cv::Mat1f& plane : image.planes) sum += std::abs(plane(a) - plane(b));
  return sum / static_cast<float>(image.planes.size());
}

Segments find_segments(const DisparityMap& map, const Image& image, const SegmentRules& rules) {
  const Image smooth = smoothed(image);
  const Graph graph(map, smooth, rules.jump);
  const std::vector<std::uint32_t> order = graph.sorted();
  DisjointSets sets(map.disparity.total());
  const auto join_where = [&](const auto& wanted) {
    for (const std::uint32_t edge : order) {
      const std::size_t a = sets.root(edge / 2), b = sets.root(graph.end_of(edge));
      if (a != b && wanted(a, b, graph.weight(edge))) sets.join(a, b, graph.weight(edge));
    }
  };
  join_where([&](std::size_t a, std::size_t b, float weight) {
    return weight <= std::min(sets.limit(a, rules.scale), sets.limit(b, rules.scale));
  });
  join_where([&](std::size_t a, std::size_t b, float) {
    return std::min(sets.size(a), sets.size(b)) < rules.min_size;
  });
  return numbered(sets, image);
}

}  // namespace xgm::plane_filling
