// SPDX-License-Identifier: Apache-2.0
// The census cost against Zabih & Woodfill's definition.
#include "plugins/cost/cost_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Whether the neighbour is darker than the centre; one that does not exist is not.
bool darker(const Image& image, std::size_t channel, int y, int x, cv::Point o) {
  const bool exists = x + o.x >= 0 && x + o.x < image.size().width && y + o.y >= 0 &&
                      y + o.y < image.size().height && image.is_valid(y + o.y, x + o.x);
  return exists && image.planes[channel](y + o.y, x + o.x) < image.planes[channel](y, x);
}

CostOracle census_oracle(cv::Size window) {
  return [window](const ImagePair& pair, int y, int x, int d) {
    double different = 0;
    for (std::size_t channel = 0; channel < pair.base.planes.size(); ++channel) {
      for (int dy = -(window.height / 2); dy <= window.height / 2; ++dy) {
        for (int dx = -(window.width / 2); dx <= window.width / 2; ++dx) {
          different += darker(pair.base, channel, y, x, {dx, dy}) !=
                       darker(pair.match, channel, y, x - d, {dx, dy});
        }
      }
    }
    return different / static_cast<double>(pair.base.planes.size());
  };
}

int max_cost(const std::string& yaml) {
  const ImagePair pair = noisy_pair({3, 3}, 1, false, false);
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 1}));
  return stage<Cost>(yaml)->run(pair, shape, Context{}).max_cost;
}

}  // namespace

TEST_CASE("census is the mean Hamming distance over the channels, rounded") {
  check_costs("{type: census, window: 3}", census_oracle({3, 3}));
  check_costs("census", census_oracle({5, 5}));
  check_costs("{type: census, window: 7}", census_oracle({7, 7}));
}

TEST_CASE("census windows of more than 64 bits lose none") {
  check_costs("{type: census, window: 9}", census_oracle({9, 9}));
}

TEST_CASE("census windows may be oblong") {
  check_costs("{type: census, window: 9, window_height: 7}", census_oracle({9, 7}));
  check_costs("{type: census, window: 3, window_height: 9}", census_oracle({3, 9}));
}

TEST_CASE("census states the number of neighbours as its largest cost, and reaches it") {
  CHECK(max_cost("census") == 24);
  CHECK(max_cost("{type: census, window: 9}") == 80);
  CHECK(max_cost("{type: census, window: 9, window_height: 7}") == 62);

  ImagePair pair{Image(cv::Mat1f(9, 9, 0.0F)), Image(cv::Mat1f(9, 9, 0.0F))};
  pair.base.planes[0](4, 4) = 1;  // all neighbours darker here, none there
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 1}));
  const CostVolume costs = stage<Cost>("{type: census, window: 9}")->run(pair, shape, Context{});
  CHECK(costs.at(4, 4)[0] == 80);
}

TEST_CASE("census gives the same costs with every SIMD target") {
  check_targets("{type: census, window: 3}");
  check_targets("census");
  check_targets("{type: census, window: 7}");
  check_targets("{type: census, window: 7, window_height: 5}");
  check_targets("{type: census, window: 9}");
}

TEST_CASE("census counts up to the last bit of three channels with every SIMD target") {
  ImagePair pair{Image(cv::Mat1f(9, 9, 0.0F)), Image(cv::Mat1f(9, 9, 0.0F))};
  for (Image* image : {&pair.base, &pair.match}) {
    for (int c = 0; c < 2; ++c) image->planes.push_back(image->planes[0].clone());
  }
  for (cv::Mat1f& plane : pair.base.planes) plane(4, 4) = 1;
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 1}));
  with_each_simd_target([&] {
    const CostVolume costs = stage<Cost>("{type: census, window: 9}")->run(pair, shape, Context{});
    CHECK(costs.at(4, 4)[0] == 80);
  });
}

TEST_CASE("census does not see gain and offset") {
  const ImagePair pair = noisy_pair({40, 20}, 3, false, false);
  ImagePair brighter = pair;
  for (cv::Mat1f& plane : brighter.match.planes) plane = cv::Mat1f(plane * 0.5F + 31.0F);
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 5}));
  const auto cost = stage<Cost>("census");
  CHECK(identical(cost->run(pair, shape, Context{}), cost->run(brighter, shape, Context{})));
}

TEST_CASE("census is symmetric") { check_symmetry("census"); }

TEST_CASE("census does not depend on the number of threads") { check_threads("census"); }

TEST_CASE("census compares a grey view with a colour view in grey") { check_mixed_views("census"); }

TEST_CASE("census refuses even windows and heights") {
  CHECK_THROWS_AS(stage<Cost>("{type: census, window: 4}"), Error);
  CHECK_THROWS_AS(stage<Cost>("{type: census, window: 11}"), Error);
  CHECK_THROWS_AS(stage<Cost>("{type: census, window_height: 1}"), Error);
  CHECK_THROWS_AS(stage<Cost>("{type: census, window_height: 6}"), Error);
}
