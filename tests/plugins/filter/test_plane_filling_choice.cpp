// SPDX-License-Identifier: Apache-2.0
// Candidates, costs and choice of plane_filling against what their comments say, written
// plainly.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "plugins/filter/plane_filling/candidate_costs.hpp"
#include "plugins/filter/plane_filling/choice.hpp"
#include "tests/plugins/filter/plane_filling_inputs.hpp"

using namespace xgm;
using namespace xgm::plane_filling;
using namespace xgm::testing;

namespace {

const std::vector<cv::Point> kEightSteps{{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                         {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

/// Some map, guide, segments and planes to work on.
struct World {
  World(cv::Size size, std::uint64_t seed)
      : map(random_map(size, {-3, 6, 0.5, 0.4}, seed)),
        pair{masked_guide(size, 3, seed), masked_guide(size, 3, seed + 7)} {
    Random random(seed);
    segments.label = cv::Mat1i(size);
    segments.count = 5;
    for (int& label : segments.label) label = random.integer(0, segments.count - 1);
    segments.label.setTo(-1, pair.base.valid == 0);
    planes.resize(static_cast<std::size_t>(segments.count));
    for (std::size_t i = 1; i < planes.size(); ++i) planes[i] = random_plane(random);
    doubted = random_map(size, {-3, 6, 0.5, 0.7}, seed + 1).disparity;
    holes = find_holes(map, pair.base);
    candidates = find_candidates(holes, map, doubted, segments, planes);
  }
  DisparityMap map;
  cv::Mat1f doubted;
  ImagePair pair;
  Segments segments;
  std::vector<std::optional<Plane>> planes;
  Holes holes;
  CandidateLists candidates;
};

/// Mean absolute difference of the planes of two pixels.
double colour_distance(const Image& image, cv::Point a, cv::Point b) {
  double sum = 0;
  for (const cv::Mat1f& plane : image.planes) sum += std::abs(double{plane(a)} - double{plane(b)});
  return sum / static_cast<double>(image.planes.size());
}

/// Disparity and path of each candidate.
using Offers = std::vector<std::pair<double, double>>;

Offers naive_offers(const World& world, cv::Point hole) {
  const auto [lowest, highest] = [&] {
    double low = 1e9, high = -1e9;
    for (int y = 0; y < world.map.size().height; ++y) {
      for (int x = 0; x < world.map.size().width; ++x) {
        if (!world.map.has_disparity(y, x)) continue;
        low = std::min(low, double{world.map.disparity(y, x)});
        high = std::max(high, double{world.map.disparity(y, x)});
      }
    }
    return std::pair(low, high);
  }();
  const Image& image = world.pair.base;
  const auto plane_at = [&](cv::Point p) {
    return world.planes[static_cast<std::size_t>(world.segments.label(p))];
  };
  std::map<std::tuple<float, float, float>, double> path_of;
  const auto offer = [&](const Plane& plane, double path) {
    const auto key = std::tuple(plane.along_x, plane.along_y, plane.offset);
    const auto known = path_of.find(key);
    path_of[key] = known == path_of.end() ? path : std::min(path, known->second);
  };
  const auto possible = [&, low = lowest, high = highest](const Plane& plane) {
    const double d{plane.at(hole.y, hole.x)};
    return low <= d && d <= high;
  };
  if (!std::isnan(world.doubted(hole))) offer({0, 0, world.doubted(hole)}, 0);
  if (const auto own = plane_at(hole); own && possible(*own)) offer(*own, 0);
  for (const cv::Point step : kEightSteps) {
    double path = 0;
    cv::Point p = hole;
    for (;; p += step) {
      if (!inside(world.map.size(), p)) break;
      if (image.is_valid(p.y, p.x) && world.map.has_disparity(p.y, p.x)) break;
      const cv::Point next = p + step;
      if (!inside(world.map.size(), next)) continue;
      if (image.is_valid(p.y, p.x) && image.is_valid(next.y, next.x)) {
        path += colour_distance(image, p, next);
      }
    }
    if (!inside(world.map.size(), p)) continue;
    const float there = world.map.disparity(p);
    const auto plane = plane_at(p);
    const bool lies = plane && std::abs(plane->at(p.y, p.x) - there) < 1;
    offer(lies && possible(*plane) ? *plane : Plane{0, 0, there}, path);
  }
  Offers offers;
  for (const auto& [key, path] : path_of) {
    const Plane plane{std::get<0>(key), std::get<1>(key), std::get<2>(key)};
    offers.emplace_back(double{plane.at(hole.y, hole.x)}, path);
  }
  return offers;
}

/// The path costs of all candidates of `hole`, found by going back to where the path begins.
std::vector<double> naive_path(const World& world, const std::vector<float>& costs,
                               const Smoothness& s, std::size_t hole, cv::Point step) {
  const auto candidates = world.candidates.of(hole);
  const std::size_t begin = world.candidates.begin[hole];
  std::vector<double> path(costs.begin() + static_cast<std::ptrdiff_t>(begin),
                           costs.begin() + static_cast<std::ptrdiff_t>(begin + candidates.size()));
  const cv::Point here = world.holes.at[hole], before = here - step;
  const Image& image = world.pair.base;
  if (!inside(world.map.size(), before) || !image.is_valid(before.y, before.x)) return path;
  const double distance = colour_distance(image, here, before);
  const double weight = std::max(0.05, std::exp(-distance / double{s.sigma}));
  const auto penalty = [&](float a, float b) {
    return weight * std::min(double{s.slope} * std::abs(double{a} - double{b}), double{s.jump});
  };
  if (world.map.has_disparity(before.y, before.x)) {
    for (std::size_t k = 0; k < path.size(); ++k) {
      path[k] += penalty(candidates[k].disparity, world.map.disparity(before));
    }
    return path;
  }
  const int number = world.holes.number(before);
  if (number < 0) return path;
  const auto from = static_cast<std::size_t>(number);
  const std::vector<double> last = naive_path(world, costs, s, from, step);
  if (last.empty()) return path;
  const double least = *std::min_element(last.begin(), last.end());
  for (std::size_t k = 0; k < path.size(); ++k) {
    double best = 1e9;
    for (std::size_t l = 0; l < last.size(); ++l) {
      best = std::min(best,
                      last[l] - least +
                          penalty(candidates[k].disparity, world.candidates.of(from)[l].disparity));
    }
    path[k] += best;
  }
  return path;
}

std::vector<float> random_costs(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> costs(count);
  for (float& cost : costs) cost = static_cast<float>(random.real(0, 2));
  return costs;
}

/// Bits of a 7x7 census that differ, counted one by one.
int differing_bits(const ImagePair& pair, cv::Point p, int there) {
  const cv::Mat1f base = pair.base.grey(), match = pair.match.grey();
  int count = 0;
  for (int dy = -3; dy <= 3; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      const auto darker = [&](const Image& image, const cv::Mat1f& grey, cv::Point centre) {
        const cv::Point q = centre + cv::Point(dx, dy);
        return inside(grey.size(), q) && image.is_valid(q.y, q.x) && grey(q) < grey(centre);
      };
      count += darker(pair.base, base, p) != darker(pair.match, match, {there, p.y});
    }
  }
  return count;
}

double naive_matching(const ImagePair& pair, const CostRules& rules, cv::Point p, float d) {
  const cv::Mat1f base = pair.base.grey(), match = pair.match.grey();
  const double where = double{static_cast<float>(p.x) - d};
  const int nearest = cvRound(where), left = cvFloor(where);
  const auto seen = [&](int x) { return x >= 0 && x < match.cols && pair.match.is_valid(p.y, x); };
  if (!seen(nearest)) return double{rules.occlusion};
  double level{match(p.y, nearest)};
  if (seen(left) && seen(left + 1)) {
    const double t = where - left;
    level = (1 - t) * double{match(p.y, left)} + t * double{match(p.y, left + 1)};
  }
  return 0.5 * std::min(1.0, differing_bits(pair, p, nearest) / 24.0) +
         0.5 * std::min(1.0, std::abs(double{base(p)} - level) / 20);
}

double naive_cost(const World& world, const CostRules& rules, cv::Point p,
                  const Candidate& candidate) {
  double matching = naive_matching(world.pair, rules, p, candidate.disparity), hides = 0;
  const int there = cvRound(static_cast<float>(p.x) - candidate.disparity);
  double nearest = rules.near_is_high ? -1e9 : 1e9;
  for (int x = 0; x < world.map.size().width; ++x) {
    if (!world.map.has_disparity(p.y, x)) continue;
    const float d = world.map.disparity(p.y, x);
    if (cvRound(static_cast<float>(x) - d) != there) continue;
    nearest = rules.near_is_high ? std::max(nearest, double{d}) : std::min(nearest, double{d});
  }
  const bool visible =
      there >= 0 && there < world.map.size().width && world.pair.match.is_valid(p.y, there);
  const double front = (rules.near_is_high ? 1 : -1) * (nearest - double{candidate.disparity});
  if (visible && front > 1) matching = std::min(matching, double{rules.occlusion});
  if (visible && front < -1 && std::abs(nearest) < 1e9) hides = double{rules.hides};
  return matching + hides + double{rules.path} * std::min(60.0, double{candidate.path});
}

}  // namespace

TEST_CASE("plane_filling: each hole is offered the planes that it sees") {
  for (const cv::Size size : kMapSizes) {
    CAPTURE(size);
    const World world(size, 11);
    std::size_t hole = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool is_hole = !world.map.has_disparity(y, x) && world.map.at(y, x) != Status::masked;
        const bool has_data = world.pair.base.is_valid(y, x);
        CHECK((world.holes.number(y, x) >= 0) == (!world.map.has_disparity(y, x) || !has_data));
        if (world.holes.number(y, x) < 0) continue;
        CHECK(world.holes.number(y, x) == static_cast<int>(hole));
        CHECK((world.holes.is_filled[hole] != 0) == (is_hole && has_data));
        if (world.holes.is_filled[hole] == 0) {
          CHECK(world.candidates.of(hole++).empty());
          continue;
        }
        Offers offers;
        for (const Candidate& c : world.candidates.of(hole)) {
          offers.emplace_back(double{c.disparity}, double{c.path});
        }
        Offers expected = naive_offers(world, world.holes.at[hole]);
        std::sort(offers.begin(), offers.end());
        std::sort(expected.begin(), expected.end());
        REQUIRE(offers.size() == expected.size());
        for (std::size_t i = 0; i < offers.size(); ++i) {
          CHECK(offers[i].first == expected[i].first);
          CHECK(offers[i].second == doctest::Approx(expected[i].second).epsilon(1e-4));
        }
        ++hole;
      }
    }
  }
}

TEST_CASE("plane_filling: costs are those of the images, of hiding and of the path") {
  for (const bool near_is_high : {true, false}) {
    CostRules rules;
    rules.near_is_high = near_is_high;
    const World world({31, 22}, 21);
    const CandidateCosts costs(world.map, world.pair, rules);
    for (std::size_t hole = 0; hole < world.holes.at.size(); ++hole) {
      const cv::Point at = world.holes.at[hole];
      for (const Candidate& candidate : world.candidates.of(hole)) {
        const double expected = naive_cost(world, rules, at, candidate);
        CHECK(costs.of(at, candidate) == doctest::Approx(expected).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("plane_filling: the choice has the least sum of path costs") {
  for (const cv::Size size : kMapSizes) {
    CAPTURE(size);
    const World world(size, 31);
    const std::vector<float> costs = random_costs(world.candidates.all.size(), 1);
    const Smoothness smoothness{0.3F, 1, 10};
    const auto chosen = choose(world.holes, world.candidates, costs, world.map, smoothness);
    REQUIRE(chosen.size() == world.holes.at.size());
    for (std::size_t hole = 0; hole < chosen.size(); ++hole) {
      if (world.candidates.of(hole).empty()) continue;
      std::vector<double> sum(world.candidates.of(hole).size(), 0.0);
      for (const cv::Point step : kEightSteps) {
        const std::vector<double> path = naive_path(world, costs, smoothness, hole, step);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += path[k];
      }
      const double least = *std::min_element(sum.begin(), sum.end());
      CHECK(sum[chosen[hole]] == doctest::Approx(least).epsilon(1e-5));
    }
  }
}
