// SPDX-License-Identifier: Apache-2.0
// The correlation cost against the textbook formula, window by window.
#include "plugins/cost/cost_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Samples {
  std::vector<double> base, match;
};

/// The samples of a window that exist in both views.
Samples window_samples(const ImagePair& pair, std::size_t channel, int y, int x, int d,
                       int radius) {
  Samples samples;
  for (int v = y - radius; v <= y + radius; ++v) {
    for (int u = x - radius; u <= x + radius; ++u) {
      const cv::Rect image({0, 0}, pair.size());
      if (!image.contains(cv::Point(u, v)) || !image.contains(cv::Point(u - d, v))) continue;
      if (!pair.base.is_valid(v, u) || !pair.match.is_valid(v, u - d)) continue;
      samples.base.push_back(pair.base.planes[channel](v, u));
      samples.match.push_back(pair.match.planes[channel](v, u - d));
    }
  }
  return samples;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double correlation(const Samples& samples) {
  const double mean_b = mean(samples.base);
  const double mean_m = mean(samples.match);
  double bb = 0, mm = 0, bm = 0;
  for (std::size_t i = 0; i < samples.base.size(); ++i) {
    bb += (samples.base[i] - mean_b) * (samples.base[i] - mean_b);
    mm += (samples.match[i] - mean_m) * (samples.match[i] - mean_m);
    bm += (samples.base[i] - mean_b) * (samples.match[i] - mean_m);
  }
  const double flat = 1e-6 * static_cast<double>(samples.base.size());
  return bb <= flat || mm <= flat ? 0 : bm / std::sqrt(bb * mm);
}

CostOracle zncc_oracle(int window, double scale) {
  return [=](const ImagePair& pair, int y, int x, int d) {
    double sum = 0;
    for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
      sum += correlation(window_samples(pair, c, y, x, d, window / 2));
    }
    return scale * (1 - sum / static_cast<double>(pair.base.planes.size())) / 2;
  };
}

/// All cells at disparity 0 of the cost of these views.
std::vector<int> costs_at_zero(const cv::Mat1f& base, const cv::Mat1f& match) {
  const ImagePair pair{Image(base), Image(match)};
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 1}));
  const CostVolume costs = stage<Cost>("{type: zncc, scale: 100}")->run(pair, shape, Context{});
  const auto cells = all_cells(costs);
  return {cells.begin(), cells.end()};
}

}  // namespace

TEST_CASE("zncc is the correlation of the samples that exist in both views, mean over channels") {
  check_costs("zncc", zncc_oracle(7, 100), 1e-9);
  check_costs("{type: zncc, window: 3, scale: 254}", zncc_oracle(3, 254), 1e-9);
  check_costs("{type: zncc, window: 13, scale: 60}", zncc_oracle(13, 60), 1e-9);
}

TEST_CASE("zncc does not see gain and offset, and calls a negative unlike") {
  const cv::Mat1f image = random_image({40, 20}, 1).planes[0];
  for (const int cost : costs_at_zero(image, cv::Mat1f(image * 0.5F + 31.0F))) CHECK(cost == 0);
  for (const int cost : costs_at_zero(image, cv::Mat1f(255.0F - image))) CHECK(cost == 100);
}

TEST_CASE("zncc of a flat window is neither like nor unlike") {
  cv::Mat1f flat(20, 40, 200.1F);
  for (int x = 0; x < 40; x += 3) flat.col(x) = std::nextafter(200.1F, 201.0F);  // rounding
  const cv::Mat1f noise = random_image({40, 20}, 1).planes[0];
  for (const int cost : costs_at_zero(flat, flat)) CHECK(cost == 50);
  for (const int cost : costs_at_zero(flat, noise)) CHECK(cost == 50);
  for (const int cost : costs_at_zero(noise, flat)) CHECK(cost == 50);
}

TEST_CASE("zncc finds weak texture on a bright ground") {
  const cv::Mat1f weak = cv::Mat1f(random_image({40, 20}, 1).planes[0] / 2550.0F + 254.0F);
  for (const int cost : costs_at_zero(weak, weak)) CHECK(cost == 0);
}

TEST_CASE("zncc is symmetric") { check_symmetry("zncc"); }

TEST_CASE("zncc does not depend on the number of threads") { check_threads("zncc"); }

TEST_CASE("zncc compares a grey view with a colour view in grey") { check_mixed_views("zncc"); }
