// SPDX-License-Identifier: Apache-2.0
// One surface of several, cell by cell.
#include <algorithm>
#include <cmath>
#include <random>

#include "geo/cameras.hpp"
#include "geo/recorder.hpp"
#include "support/support.hpp"
#include "xgm/geo/stage/fusion.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;

namespace {

/// Surfaces of one cell each.
std::vector<Raster> cells(const std::vector<float>& heights) {
  std::vector<Raster> surfaces;
  for (const float h : heights) surfaces.push_back({cv::Mat1f(1, 1, h), {}, {}, {}});
  return surfaces;
}

float fused(const std::string& yaml, const std::vector<float>& heights) {
  return geo_stage<Fusion>(yaml)->run(cells(heights), Context()).heights.values(0, 0);
}

double middle(std::vector<float> v) {
  std::sort(v.begin(), v.end());
  const std::size_t n = v.size();
  return (double{v[(n - 1) / 2]} + double{v[n / 2]}) / 2;
}

/// The smallest sum of distances to the medians of k groups, by trying every group of every value.
double smallest_sum(const std::vector<float>& values, std::size_t k, float* lowest) {
  double best = INFINITY;
  std::size_t ways = 1;
  for (std::size_t i = 0; i < values.size(); ++i) ways *= k;
  for (std::size_t way = 0; way < ways; ++way) {
    std::vector<std::vector<float>> groups(k);
    std::size_t rest = way;
    for (const float v : values) {
      groups[rest % k].push_back(v);
      rest /= k;
    }
    double sum = 0, low = INFINITY;
    for (const auto& group : groups) {
      if (group.empty()) {
        sum = INFINITY;
        break;
      }
      low = std::min(low, middle(group));
      for (const float v : group) sum += std::abs(double{v} - middle(group));
    }
    if (sum < best - 1e-9) {
      best = sum;
      *lowest = static_cast<float>(low);
    }
  }
  return best;
}

}  // namespace

TEST_CASE("k medians are the best of all groups, the lowest of which is taken") {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> height(0, 100);
  for (const std::size_t k : {1U, 2U, 3U}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<float> heights(k + 1 + static_cast<std::size_t>(round) % 5);
      for (float& h : heights) h = height(random);
      float lowest = 0;
      smallest_sum(heights, k, &lowest);
      // So precise that k is used up.
      const std::string yaml =
          "{type: k_medians, precision: 0.001, min_share: 0, k: " + std::to_string(k) + "}";
      CHECK(fused(yaml, heights) == doctest::Approx(lowest).epsilon(1e-6));
    }
  }
}

TEST_CASE("as few clusters are made as precision needs, and the choice is followed") {
  const std::vector<float> heights{10.2F, 10, 30.1F, 30, 29.9F, 10.1F, 30.2F, NAN, 80};
  CHECK(fused("k_medians", heights) == doctest::Approx(10.1));
  CHECK(fused("{type: k_medians, choice: largest}", heights) == doctest::Approx(30.05));
  CHECK(fused("{type: k_medians, choice: highest}", heights) == doctest::Approx(30.05));
  CHECK(fused("{type: k_medians, choice: highest, min_share: 0}", heights) == 80);
  CHECK(fused("{type: k_medians, min_share: 1}", heights) == doctest::Approx(30.05));
  CHECK(fused("{type: k_medians, k: 1}", heights) == doctest::Approx(29.95));
  CHECK(fused("{type: k_medians, precision: 100}", heights) == doctest::Approx(29.95));
  CHECK(fused("k_medians", {7}) == 7);
  CHECK(fused("k_medians", {7, 7, 7}) == 7);
  CHECK(std::isnan(fused("k_medians", {NAN, NAN})));
  CHECK(std::isnan(fused("{type: k_medians, min_pairs: 3}", {1, 2, NAN})));
}

TEST_CASE("a surface that lies 3 m too high is found, and taken out if asked") {
  std::mt19937 random(9);
  std::normal_distribution<float> noise(0, 0.2F);
  std::vector<Raster> surfaces;
  for (int i = 0; i < 6; ++i) {
    Raster surface{cv::Mat1f(40, 50), {}, {}, {}};
    for (float& h : surface.values) h = 100 + noise(random) + (i == 4 ? 3.0F : 0.0F);
    surfaces.push_back(surface);
  }
  for (const std::string name : {"median", "k_medians"}) {
    CAPTURE(name);
    Recorder recorder;
    const FusedSurface as_is = geo_stage<Fusion>(name)->run(surfaces, Context(&recorder));
    CHECK(recorder.figures.at("offset_5_m") == doctest::Approx(3).epsilon(0.05));
    CHECK(std::abs(recorder.figures.at("offset_1_m")) < 0.1);
    CHECK(as_is.offsets[4] == doctest::Approx(3).epsilon(0.05));
    CHECK(as_is.count(3, 3) == 6);
    CHECK(as_is.spread(3, 3) < 0.6);
    const FusedSurface aligned =
        geo_stage<Fusion>("{type: " + name + ", align: true}")->run(surfaces, Context());
    CHECK(std::abs(cv::mean(aligned.heights.values)[0] - 100) < 0.1);
  }
}
