// SPDX-License-Identifier: Apache-2.0
// Segments and planes of plane_filling against what their publications say, written plainly.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "tests/plugins/filter/plane_filling_inputs.hpp"

using namespace xgm;
using namespace xgm::plane_filling;
using namespace xgm::testing;

namespace {

double smooth_level(const Image& image, const cv::Mat1f& plane, cv::Point p) {
  double sum = 0, weights = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const cv::Point q = p + cv::Point(dx, dy);
      if (!inside(plane.size(), q) || !image.is_valid(q.y, q.x)) continue;
      const double weight = (2 - std::abs(dx)) * (2 - std::abs(dy));
      sum += weight * double{plane(q)};
      weights += weight;
    }
  }
  return sum / weights;
}

/// Felzenszwalb and Huttenlocher by sets of pixels that are relabelled one by one.
cv::Mat1i naive_segments(const DisparityMap& map, const Image& image, const SegmentRules& rules) {
  const cv::Size size = map.size();
  struct Edge {
    int weight;
    cv::Point a, b;
  };
  std::vector<Edge> edges;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (const cv::Point q : {cv::Point(x + 1, y), cv::Point(x, y + 1)}) {
        const cv::Point p(x, y);
        if (!inside(size, q) || !image.is_valid(y, x) || !image.is_valid(q.y, q.x)) continue;
        const double jump = std::abs(double{map.disparity(p)} - double{map.disparity(q)});
        if (jump > rules.jump) continue;
        double sum = 0;
        for (const cv::Mat1f& plane : image.planes) {
          sum += std::abs(smooth_level(image, plane, p) - smooth_level(image, plane, q));
        }
        // Floats round otherwise than doubles: a little more, so that whole steps stay whole.
        const double mean = sum / static_cast<double>(image.planes.size());
        edges.push_back({static_cast<int>(255 * mean), p, q});
      }
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.weight < b.weight; });
  cv::Mat1i label(size);
  std::iota(label.begin(), label.end(), 0);
  std::map<int, double> inner;
  const auto join_where = [&](const auto& wanted) {
    for (const Edge& edge : edges) {
      const int a = label(edge.a), b = label(edge.b);
      if (a == b || !wanted(edge, a, b)) continue;
      inner[a] = std::max({inner[a], inner[b], edge.weight / 255.0});
      label.setTo(a, label == b);
    }
  };
  const auto pixels = [&](int segment) { return cv::countNonZero(label == segment); };
  join_where([&](const Edge& edge, int a, int b) {
    return edge.weight / 255.0 <=
           std::min(inner[a] + rules.scale / pixels(a), inner[b] + rules.scale / pixels(b)) + 1e-6;
  });
  join_where(
      [&](const Edge&, int a, int b) { return std::min(pixels(a), pixels(b)) < rules.min_size; });
  if (!image.valid.empty()) label.setTo(-1, image.valid == 0);
  return label;
}

/// Whether two labellings part the pixels alike.
bool same_parts(const cv::Mat1i& a, const cv::Mat1i& b) {
  std::map<int, int> to, from;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      if ((a(y, x) < 0) != (b(y, x) < 0)) return false;
      if (to.emplace(a(y, x), b(y, x)).first->second != b(y, x)) return false;
      if (from.emplace(b(y, x), a(y, x)).first->second != a(y, x)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("plane_filling: segments are those of Felzenszwalb and Huttenlocher") {
  for (const cv::Size size : kMapSizes) {
    for (const int planes : {1, 3}) {
      for (const SegmentRules& rules :
           {SegmentRules{20, 1, 1.5}, SegmentRules{60, 6, 0.5}, SegmentRules{5, 1, 1e6}}) {
        CAPTURE(size);
        const Image image = masked_guide(size, planes, 5);
        const DisparityMap map = random_map(size, {0, 2, 0.5, 0.4}, 9);
        const Segments segments = find_segments(map, image, rules);
        CHECK(same_parts(segments.label, naive_segments(map, image, rules)));
      }
    }
  }
}

TEST_CASE(
    "plane_filling: planes are found among a third of outliers, and not where there is none") {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Plane truth = random_plane(random);
    std::vector<Sample> good, bad;
    for (int i = 0; i < 300; ++i) {
      const cv::Point at(random.integer(0, 60), random.integer(0, 40));
      const float noise = static_cast<float>(random.real(-0.1, 0.1));
      const float wild = static_cast<float>(random.real(-40, 80));
      good.push_back({at, i % 3 == 0 ? wild : truth.at(at.y, at.x) + noise});
      bad.push_back({at, wild});
    }
    const std::optional<Plane> plane = fit_plane(good);
    REQUIRE(plane);
    for (const cv::Point corner : {cv::Point(0, 0), {60, 0}, {0, 40}, {60, 40}}) {
      CHECK(std::abs(plane->at(corner.y, corner.x) - truth.at(corner.y, corner.x)) < 0.1F);
    }
    CHECK_FALSE(fit_plane(bad));
  }
  CHECK_FALSE(fit_plane(std::vector<Sample>(9, {{3, 4}, 5.0F})));
  const std::optional<Plane> point = fit_plane(std::vector<Sample>(10, {{3, 4}, 5.0F}));
  REQUIRE(point);
  CHECK(point->at(4, 3) == doctest::Approx(5));
}
