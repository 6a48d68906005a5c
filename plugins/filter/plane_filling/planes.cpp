// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

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

/// Some of the samples, which judge planes: coordinate by coordinate, for loops of vectors.
class Judges {
 public:
  explicit Judges(std::span<const Sample> samples) {
    const std::size_t step = std::max<std::size_t>(1, samples.size() / kScored);
    for (std::size_t i = 0; i < samples.size(); i += step) {
      add(static_cast<float>(samples[i].at.x), static_cast<float>(samples[i].at.y),
          samples[i].disparity);
    }
    // An outlier of every plane makes no difference between them.
    while (x_.size() % kLanes != 0) add(0, 0, std::numeric_limits<float>::infinity());
  }

  float score(const Plane& plane) const {
    std::array<float, kLanes> sums{};
    for (std::size_t i = 0; i < x_.size(); i += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t k = i + lane;
        const float there = plane.along_x * x_[k] + plane.along_y * y_[k] + plane.offset;
        sums[lane] += std::min(std::abs(there - disparity_[k]), kInlier);
      }
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0F);
  }

 private:
  static constexpr std::size_t kLanes = 8;
  void add(float x, float y, float disparity) {
    x_.push_back(x);
    y_.push_back(y);
    disparity_.push_back(disparity);
  }
  std::vector<float> x_, y_, disparity_;
};

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

Plane facing_the_camera(std::span<const Sample> samples) {
  std::vector<float> disparities;
  disparities.reserve(samples.size());
  for (const Sample& sample : samples) disparities.push_back(sample.disparity);
  const auto middle = disparities.begin() + static_cast<std::ptrdiff_t>(disparities.size() / 2);
  std::nth_element(disparities.begin(), middle, disparities.end());
  return {0, 0, *middle};
}

Plane best_of_trials(std::span<const Sample> samples) {
  const Judges judges(samples);
  Plane best = facing_the_camera(samples);
  float least = judges.score(best);
  Random random(samples.size());
  const auto any = [&]() -> const Sample& { return samples[random.next() % samples.size()]; };
  for (int trial = 0; trial < kTrials; ++trial) {
    const Sample &a = any(), &b = any(), &c = any();
    const std::optional<Plane> plane = through(a, b, c);
    if (!plane) continue;
    const float sum = judges.score(*plane);
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

Refined least_squares(const Plane& plane, std::span<const Sample> samples) {
  const cv::Point origin = samples.front().at;
  double xx = kRidge, xy = 0, yy = kRidge, x = 0, y = 0, xd = 0, yd = 0, d = 0;
  std::size_t inliers = 0;
  for (const Sample& sample : samples) {
    if (residual(plane, sample) > kInlier) continue;
    const double u = sample.at.x - origin.x, v = sample.at.y - origin.y;
    const double disparity{sample.disparity};
    xx += u * u, xy += u * v, yy += v * v;
    x += u, y += v, d += disparity;
    xd += u * disparity, yd += v * disparity;
    ++inliers;
  }
  if (inliers < kFewest) return {plane, inliers};
  const cv::Matx33d normal(xx, xy, x, xy, yy, y, x, y, static_cast<double>(inliers));
  const cv::Vec3d found = normal.solve(cv::Vec3d(xd, yd, d), cv::DECOMP_CHOLESKY);
  const double offset = found[2] - found[0] * origin.x - found[1] * origin.y;
  return {{static_cast<float>(found[0]), static_cast<float>(found[1]), static_cast<float>(offset)},
          inliers};
}

/// The pixels that have a disparity, segment by segment, row by row: those of segment i have the
/// numbers from begin[i] to begin[i + 1].
struct Samples {
  std::vector<std::size_t> begin;
  std::vector<Sample> all;
};

template <class Visit>
void for_each_sample(const DisparityMap& map, const Segments& segments, const Visit& visit) {
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      const int label = segments.label(y, x);
      if (label >= 0 && map.has_disparity(y, x)) visit(static_cast<std::size_t>(label), y, x);
    }
  }
}

Samples samples_of(const DisparityMap& map, const Segments& segments) {
  Samples samples{std::vector<std::size_t>(static_cast<std::size_t>(segments.count) + 1, 0), {}};
  for_each_sample(map, segments, [&](std::size_t label, int, int) { ++samples.begin[label + 1]; });
  std::partial_sum(samples.begin.begin(), samples.begin.end(), samples.begin.begin());
  samples.all.resize(samples.begin.back());
  std::vector<std::size_t> next = samples.begin;
  for_each_sample(map, segments, [&](std::size_t label, int y, int x) {
    samples.all[next[label]++] = {{x, y}, map.disparity(y, x)};
  });
  return samples;
}

}  // namespace

std::optional<Plane> fit_plane(std::span<const Sample> samples) {
  if (samples.size() < kFewest) return std::nullopt;
  Refined refined{best_of_trials(samples), 0};
  for (int round = 0; round < kRounds; ++round) refined = least_squares(refined.plane, samples);
  if (2 * refined.inliers < samples.size()) return std::nullopt;
  return refined.plane;
}

std::vector<std::optional<Plane>> fit_planes(const DisparityMap& map, const Segments& segments) {
  const Samples samples = samples_of(map, segments);
  std::vector<std::optional<Plane>> planes(static_cast<std::size_t>(segments.count));
  parallel_for(0, segments.count, [&](int i) {
    const std::size_t begin = samples.begin[static_cast<std::size_t>(i)];
    const std::size_t end = samples.begin[static_cast<std::size_t>(i) + 1];
    planes[static_cast<std::size_t>(i)] =
        fit_plane(std::span(samples.all).subspan(begin, end - begin));
  });
  return planes;
}

}  // namespace xgm::plane_filling
