// SPDX-License-Identifier: Apache-2.0
// The sampling-insensitive difference against Birchfield & Tomasi's definition.
#include <algorithm>

#include "plugins/cost/cost_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Grey level at x + t, -1/2 <= t <= 1/2, of the linearly interpolated row.
double interpolated(const Image& image, std::size_t channel, int y, int x, double t) {
  const cv::Mat1f& plane = image.planes[channel];
  const int other = t < 0 ? x - 1 : x + 1;
  const bool exists = other >= 0 && other < plane.cols && image.is_valid(y, other);
  const double here = plane(y, x);
  return exists ? (1 - std::abs(t)) * here + std::abs(t) * plane(y, other) : here;
}

/// min over t of |a(x) - b(x' + t)|: the interpolated row is linear on each side, so the minimum is
/// at an end of a side, or 0 if the level lies between two ends.
double one_way(const Image& a, int xa, const Image& b, int xb, std::size_t channel, int y) {
  const double level = a.planes[channel](y, xa);
  double least = std::abs(level - b.planes[channel](y, xb));
  for (const double t : {-0.5, 0.5}) {
    const double end = interpolated(b, channel, y, xb, t);
    const double middle = interpolated(b, channel, y, xb, 0);
    if ((end - level) * (middle - level) <= 0) return 0;
    least = std::min(least, std::abs(level - end));
  }
  return least;
}

CostOracle birchfield_tomasi_oracle(double truncation) {
  return [truncation](const ImagePair& pair, int y, int x, int d) {
    double sum = 0;
    for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
      sum += std::min(one_way(pair.base, x, pair.match, x - d, c, y),
                      one_way(pair.match, x - d, pair.base, x, c, y));
    }
    return std::min(sum / static_cast<double>(pair.base.planes.size()), truncation);
  };
}

}  // namespace

TEST_CASE("birchfield_tomasi is the least difference within half a pixel, mean over channels") {
  check_costs("birchfield_tomasi", birchfield_tomasi_oracle(64));
  check_costs("{type: birchfield_tomasi, truncation: 7}", birchfield_tomasi_oracle(7));
  check_costs("{type: birchfield_tomasi, truncation: 254}", birchfield_tomasi_oracle(254));
}

TEST_CASE("birchfield_tomasi does not see a shift of half a pixel on a ramp") {
  ImagePair pair{Image(cv::Mat1f(1, 9)), Image(cv::Mat1f(1, 9))};
  for (int x = 0; x < 9; ++x) {
    pair.base.planes[0](0, x) = static_cast<float>(20 * x);
    pair.match.planes[0](0, x) = static_cast<float>(20 * x + 10);
  }
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 1}));
  const CostVolume costs = stage<Cost>("birchfield_tomasi")->run(pair, shape, Context{});
  for (int x = 0; x < 9; ++x) CHECK(costs.at(0, x)[0] == 0);
}

TEST_CASE("birchfield_tomasi gives the same costs with every SIMD target") {
  check_targets("{type: birchfield_tomasi, truncation: 90}");
}

TEST_CASE("birchfield_tomasi is symmetric") { check_symmetry("birchfield_tomasi"); }

TEST_CASE("birchfield_tomasi does not depend on the number of threads") {
  check_threads("birchfield_tomasi");
}

TEST_CASE("birchfield_tomasi compares a grey view with a colour view in grey") {
  check_mixed_views("birchfield_tomasi");
}
