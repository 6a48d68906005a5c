// SPDX-License-Identifier: Apache-2.0
#include "bench/stages/inputs.hpp"

#include <algorithm>

#include "xgm/testing/synthetic.hpp"

namespace xgm::bench {
namespace {

constexpr int kWidth = 640, kHeight = 480, kDepth = 64;

testing::SyntheticScene make_scene() {
  testing::SceneOptions options;
  options.size = {kWidth, kHeight};
  options.disparities = {0, kDepth};
  options.objects = 20;
  options.noise = 1;
  return testing::make_scene(options);
}

const testing::SyntheticScene& scene() {
  static const testing::SyntheticScene made = make_scene();
  return made;
}

constexpr const char* kMatcher =
    "{type: semi_global, cost: {type: census, window: 5}, penalty: {type: constant, p1: 24, p2: "
    "96},"
    " aggregation: {type: sgm, directions: 8, overcounting_correction: true}, refinement: "
    "parabola}";

}  // namespace

const Registry& builtins() {
  static const Registry registry = Registry::with_builtins();
  return registry;
}

const ImagePair& pair() { return scene().pair; }

ImagePair pair(cv::Size size) {
  ImagePair corner = pair();
  for (Image* image : {&corner.base, &corner.match}) {
    for (auto& plane : image->planes) plane = plane(cv::Rect({0, 0}, size)).clone();
  }
  return corner;
}

VolumeShapePtr dense(int disparities, cv::Size size) {
  return std::make_shared<const VolumeShape>(DisparityRange::uniform(size, {0, disparities}));
}

VolumeShapePtr ragged() {
  const cv::Size size = pair().size();
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      // As if the scene were four times as deep: jumps at objects, slopes between.
      const float truth = scene().truth(y, x);
      const int middle = truth > 0 ? static_cast<int>(4 * truth) : 0;
      const int reach = 12 + (x / 40 + y / 40) % 9;
      begin(y, x) = std::clamp(middle - reach, 0, 4 * kDepth - 2 * reach);
      end(y, x) = begin(y, x) + 2 * reach;
    }
  }
  return std::make_shared<const VolumeShape>(DisparityRange(begin, end));
}

std::int64_t cells_of(const VolumeShape& shape) {
  std::int64_t cells = 0;
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) cells += shape.count(y, x);
  }
  return cells;
}

CostVolume costs_of(const VolumeShapePtr& shape) {
  return stage<Cost>("{type: census, window: 5}")->run(pair(shape->size()), shape, {});
}

const MatchResult& maps() {
  static const MatchResult both = [] {
    const auto matcher = stage<Matcher>(kMatcher);
    const DisparityRange range = DisparityRange::uniform(pair().size(), {0, kDepth});
    MatchResult result = matcher->run({pair(), range, {}}, {});
    result.reverse = matcher->run({pair().swapped(), range.reversed(), {}}, {}).forward;
    return result;
  }();
  return both;
}

void register_all() {
  register_volumes();
  register_maps();
}

}  // namespace xgm::bench
