// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/planes.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/parallel.hpp"
#include "xgm/base/random.hpp"

namespace xgm::plane_filling {
namespace {

constexpr std::size_t kFewest = 10;   // samples of a plane
constexpr std::size_t kScored = 200;  // samples that judge a plane: more tell no better
constexpr int kTrials = 40;           // half of the samples being good, one in 200 fails
constexpr int kRounds = 3;            // of least squares
constexpr double kSteepestX = 0.5, kSteepestY = 1;  // px per px: beyond, no surface is seen
constexpr double kRidge = 20;                       // px^2: slopes of small segments are drawn to 0

float residual(const Plane& plane, const Sample& sample) {
  return std::abs(plane.at(sample.at.y, sample.at.x) - sample.disparity);
}

double score(const Plane& plane, const std::vector<Sample>& samples) {
  const std::size_t step = std::max<std::size_t>(1, samples.size() / kScored);
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    sum += double{std::min(residual(plane, samples[i]), kInlier)};
  }
  return sum;
}

/// None if the samples lie nearly on a line, or if the plane is too steep.
std::optional<Plane> through(const Sample& a, const Sample& b, const Sample& c) {
  const cv::Point ab = b.at - a.at, ac = c.at - a.at;
  const double to_b = double{b.disparity} - double{a.disparity};
  const double to_c = double{c.disparity} - double{a.disparity};
  const double area = ab.cross(ac);
  constexpr double kSmallest = 8;  // px^2
  if (std::abs(area) < kSmallest) return std::nullopt;
  const double along_x = (to_b * ac.y - to_c * ab.y) / area;
  const double along_y = (to_c * ab.x - to_b * ac.x) / area;
  if (std::abs(along_x) > kSteepestX || std::abs(along_y) > kSteepestY) return std::nullopt;
  return Plane{static_cast<float>(along_x), static_cast<float>(along_y),
               static_cast<float>(double{a.disparity} - along_x * a.at.x - along_y * a.at.y)};
}

Plane facing_the_camera(const std::vector<Sample>& samples) {
  std::vector<float> disparities;
  for (const Sample& sample : samples) disparities.push_back(sample.disparity);
  const auto middle = disparities.begin() + static_cast<std::ptrdiff_t>(disparities.size() / 2);
  std::nth_element(disparities.begin(), middle, disparities.end());
  return {0, 0, *middle};
}

Plane best_of_trials(const std::vector<Sample>& samples) {
  Plane best = facing_the_camera(samples);
  double least = score(best, samples);
  Random random(samples.size());
  const auto any = [&]() -> const Sample& { return samples[random.next() % samples.size()]; };
  for (int trial = 0; trial < kTrials; ++trial) {
    const Sample &a = any(), &b = any(), &c = any();
    const std::optional<Plane> plane = through(a, b, c);
    if (!plane) continue;
    const double sum = score(*plane, samples);
    if (sum >= least) continue;
    least = sum;
    best = *plane;
  }
  return best;
}

struct Refined {
  Plane plane;
  std::size_t inliers;  ///< of the plane before
};

Refined least_squares(const Plane& plane, const std::vector<Sample>& samples) {
  const cv::Point origin = samples.front().at;
  cv::Matx33d normal = cv::Matx33d::diag(cv::Vec3d(kRidge, kRidge, 0));
  cv::Vec3d product;
  std::size_t inliers = 0;
  for (const Sample& sample : samples) {
    if (residual(plane, sample) > kInlier) continue;
    const cv::Vec3d row(sample.at.x - origin.x, sample.at.y - origin.y, 1);
    normal += row * row.t();
    product += row * double{sample.disparity};
    ++inliers;
  }
  if (inliers < kFewest) return {plane, inliers};
  const cv::Vec3d found = normal.solve(product, cv::DECOMP_CHOLESKY);
  const double offset = found[2] - found[0] * origin.x - found[1] * origin.y;
  return {{static_cast<float>(found[0]), static_cast<float>(found[1]), static_cast<float>(offset)},
          inliers};
}

/// The pixels of each segment that have a disparity, row by row.
std::vector<std::vector<Sample>> samples_of(const DisparityMap& map, const Segments& segments) {
  std::vector<std::vector<Sample>> samples(static_cast<std::size_t>(segments.count));
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      const int label = segments.label(y, x);
      if (label < 0 || !map.has_disparity(y, x)) continue;
      samples[static_cast<std::size_t>(label)].push_back({{x, y}, map.disparity(y, x)});
    }
  }
  return samples;
}

}  // namespace

std::optional<Plane> fit_plane(const std::vector<Sample>& samples) {
  if (samples.size() < kFewest) return std::nullopt;
  Refined refined{best_of_trials(samples), 0};
  for (int round = 0; round < kRounds; ++round) refined = least_squares(refined.plane, samples);
  if (2 * refined.inliers < samples.size()) return std::nullopt;
  return refined.plane;
}

std::vector<std::optional<Plane>> fit_planes(const DisparityMap& map, const Segments& segments) {
  const std::vector<std::vector<Sample>> samples = samples_of(map, segments);
  std::vector<std::optional<Plane>> planes(samples.size());
  parallel_for(0, segments.count, [&](int i) {
    const auto label = static_cast<std::size_t>(i);
    planes[label] = fit_plane(samples[label]);
  });
  return planes;
}

}  // namespace xgm::plane_filling
