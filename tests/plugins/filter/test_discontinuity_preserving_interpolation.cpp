// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::Status;
using xgm::testing::drawn_map;
using xgm::testing::identical;

namespace {

struct Settings {
  int directions = 8;
  std::string background = "lowest";
  bool spread = true;
};

DisparityMap run(const Settings& s, const DisparityMap& map, const xgm::ImagePair& pair = {}) {
  const std::string yaml =
      "{type: discontinuity_preserving_interpolation, directions: " + std::to_string(s.directions) +
      ", background: " + s.background + ", spread_occlusions: " + (s.spread ? "true" : "false") +
      "}";
  return xgm::testing::stage<xgm::Filter>(yaml)->run(map, pair, xgm::Context{});
}

bool inside(const DisparityMap& map, cv::Point p) { return cv::Rect({}, map.size()).contains(p); }

/// Is p occluded, or reached from an occluded pixel through mismatched ones? Searched from p.
bool counts_as_occluded(const DisparityMap& map, cv::Point p, bool spread, cv::Mat1b& visited) {
  if (map.at(p.y, p.x) == Status::occluded) return true;
  if (!spread || map.at(p.y, p.x) != Status::mismatched) return false;
  visited(p) = 1;
  for (const cv::Point q :
       {p + cv::Point(1, 0), p + cv::Point(-1, 0), p + cv::Point(0, 1), p + cv::Point(0, -1)}) {
    if (!inside(map, q) || visited(q) != 0) continue;
    if (counts_as_occluded(map, q, spread, visited)) return true;
  }
  return false;
}

/// The values of the first pixels with a disparity along each path, walked one by one.
std::vector<float> seen_from(const DisparityMap& map, cv::Point p, int directions) {
  std::vector<float> seen;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int square = dx * dx + dy * dy;
      const bool step = square == 1 || square == 2 || (directions == 16 && square == 5);
      if (!step) continue;
      cv::Point q = p + cv::Point(dx, dy);
      while (inside(map, q) && !map.has_disparity(q.y, q.x)) q += cv::Point(dx, dy);
      if (inside(map, q)) seen.push_back(map.disparity(q));
    }
  }
  return seen;
}

DisparityMap oracle(const Settings& s, const DisparityMap& map) {
  DisparityMap result = map.clone();
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.has_disparity(y, x) || map.at(y, x) == Status::masked) continue;
      std::vector<float> seen = seen_from(map, {x, y}, s.directions);
      if (seen.empty()) continue;
      std::sort(seen.begin(), seen.end());
      if (s.background == "highest") std::reverse(seen.begin(), seen.end());
      cv::Mat1b visited(map.size(), 0);
      const bool occluded = counts_as_occluded(map, {x, y}, s.spread, visited);
      const std::size_t second = seen.size() > 1 ? 1 : 0;
      result.set(y, x, seen[occluded ? second : (seen.size() - 1) / 2], Status::filled);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("interpolation fills as its definition says") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const double invalid : {0.0, 0.4, 0.95, 1.0}) {
      for (const Settings& s : {Settings{8, "lowest", true}, Settings{16, "lowest", true},
                                Settings{8, "highest", true}, Settings{16, "highest", false}}) {
        CAPTURE(size);
        CAPTURE(invalid);
        const DisparityMap map = xgm::testing::random_map(size, {-12, 7, 0.25, invalid}, 21);
        const DisparityMap result = run(s, map);
        CHECK(xgm::testing::is_consistent(result));
        CHECK(identical(result, oracle(s, map)));
      }
    }
  }
}

TEST_CASE("interpolation fills occlusions from the background, mismatches from the middle") {
  const DisparityMap occluded = drawn_map({"11199", "11.99", "11199"});
  CHECK(run({}, occluded).disparity(1, 2) == 1.0F);
  CHECK(run({8, "highest", true}, occluded).disparity(1, 2) == 9.0F);
  const DisparityMap mismatched = drawn_map({"11999", "19x99", "91999"});
  CHECK(run({}, mismatched).disparity(1, 2) == 9.0F);
  CHECK(run({}, mismatched).at(1, 2) == Status::filled);
}

TEST_CASE("interpolation: one stray low disparity does not fill an occlusion") {
  CHECK(run({}, drawn_map({"33399", "33.99", "03399"})).disparity(1, 2) == 3.0F);
}

TEST_CASE("interpolation never fills masked pixels nor a map without disparities") {
  const DisparityMap masked = drawn_map({"1#1", "1.#", "111"});
  const DisparityMap result = run({}, masked);
  CHECK(result.at(0, 1) == Status::masked);
  CHECK(result.at(1, 2) == Status::masked);
  CHECK(result.at(1, 1) == Status::filled);
  const DisparityMap empty = drawn_map({"..x", "?#."});
  CHECK(identical(run({}, empty), empty));
}

TEST_CASE("interpolation takes mismatched areas that touch an occlusion for occluded") {
  // From the x on the right six paths meet an 8 and two a 1: the rule decides.
  const DisparityMap map = drawn_map({"888888", "1.xx88", "888888"});
  CHECK(run({}, map).disparity(1, 3) == oracle({}, map).disparity(1, 3));
  const DisparityMap two_far = drawn_map({"818888", "1.xx88", "888188"});
  CHECK(run({8, "lowest", true}, two_far).disparity(1, 3) == 1.0F);
  CHECK(run({8, "lowest", false}, two_far).disparity(1, 3) == 8.0F);
}

TEST_CASE("interpolation done twice changes nothing more, and filled pixels are not sources") {
  const DisparityMap map = xgm::testing::random_map({31, 22}, {0, 9, 1, 0.8}, 2);
  const DisparityMap once = run({}, map);
  CHECK(identical(run({}, once), once));
  // Each hole sees 1 on the left and 9 on the right: a chain of fills would see only 1.
  const DisparityMap chain = run({}, drawn_map({"1???9"}));
  for (int x = 1; x < 4; ++x) CHECK(chain.disparity(0, x) == 1.0F);
  const DisparityMap reversed = run({8, "highest", true}, drawn_map({"1???9"}));
  for (int x = 1; x < 4; ++x) CHECK(reversed.disparity(0, x) == 9.0F);
}

TEST_CASE("interpolation of a negated map with the other background is the negated result") {
  const DisparityMap map = xgm::testing::random_map({31, 22}, {-12, 7, 0.25, 0.5}, 77);
  DisparityMap negated = map.clone(), expected = run({8, "lowest", true}, map);
  negated.disparity *= -1.0;
  expected.disparity *= -1.0;
  const DisparityMap result = run({8, "highest", true}, negated);
  CHECK(cv::countNonZero(result.status != expected.status) == 0);
  CHECK(cv::countNonZero(result.disparity != expected.disparity) ==
        cv::countNonZero(expected.disparity != expected.disparity));  // NaN only
}

TEST_CASE("in a reverse map the background is at the other end") {
  const DisparityMap map = xgm::testing::random_map({31, 22}, {-12, 7, 0.25, 0.5}, 78);
  const xgm::ImagePair reverse = xgm::ImagePair{}.swapped();
  CHECK(identical(run({8, "lowest", true}, map, reverse), run({8, "highest", true}, map)));
  CHECK(identical(run({8, "highest", true}, map, reverse), run({8, "lowest", true}, map)));
  CHECK(identical(run({}, map, reverse.swapped()), run({}, map)));
}

TEST_CASE("interpolation gives the same map on any number of threads") {
  const DisparityMap map = xgm::testing::random_map({97, 61}, {-12, 7, 0.25, 0.5}, 5);
  const DisparityMap one = run({16, "lowest", true}, map);
  for (const int count : {1, 2, 3, 8}) {
    const xgm::ThreadLimit threads(count);
    CHECK(identical(run({16, "lowest", true}, map), one));
  }
}
