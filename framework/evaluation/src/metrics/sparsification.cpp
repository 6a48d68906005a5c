// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/sparsification.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "metrics/errors.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

constexpr int kPoints = 20;  // every 5 %, as Hu and Mordohai do

struct Pixel {
  double error = 0;  // px after scaling
  double doubt = 0;  // by which pixels are sorted: the least first
};

std::vector<Pixel> collect(const DisparityMap& map, const cv::Mat1f& truth,
                           const cv::Mat1f& confidence, const EvaluationRules& rules,
                           const cv::Mat1b& mask) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (!is_judged(truth, mask, y, x) || !map.has_disparity(y, x)) continue;
      const double sure = static_cast<double>(confidence(y, x));
      pixels.push_back({error_at(map, truth, rules, y, x),
                        std::isfinite(sure) ? -sure : std::numeric_limits<double>::infinity()});
    }
  }
  return pixels;
}

/// How many pixels are kept at each point of the curve.
std::vector<std::size_t> counts(std::size_t pixels) {
  std::vector<std::size_t> result;
  for (std::size_t i = 1; i <= kPoints; ++i) {
    result.push_back((i * pixels + kPoints - 1) / kPoints);
  }
  return result;
}

/// Means of a figure over the first 1, 2, ... of the pixels.
struct Means {
  std::vector<double> at_points;
  double area = 0;
};

/// `pixels` are sorted by doubt. Within pixels of equal doubt each adds the mean of their figures:
/// what it adds on average over all their orders.
Means means_of_the_first(const std::vector<Pixel>& pixels,
                         const std::function<double(const Pixel&)>& figure) {
  const std::vector<std::size_t> points = counts(pixels.size());
  auto next_point = points.begin();
  Means means;
  double sum = 0;
  for (std::size_t begin = 0, end = 0; begin < pixels.size(); begin = end) {
    double ties = 0;
    while (end < pixels.size() && pixels[end].doubt == pixels[begin].doubt) {
      ties += figure(pixels[end++]);
    }
    const auto tied = static_cast<double>(end - begin);
    for (std::size_t kept = begin + 1; kept <= end; ++kept) {
      const double mean =
          (sum + ties * static_cast<double>(kept - begin) / tied) / static_cast<double>(kept);
      means.area += mean;
      for (; next_point != points.end() && *next_point == kept; ++next_point) {
        means.at_points.push_back(mean);
      }
    }
    sum += ties;
  }
  means.area /= static_cast<double>(pixels.size());
  return means;
}

/// `by_doubt` and `by_error` hold the same pixels in two orders.
SparsificationCurve curve(const std::vector<Pixel>& by_doubt, const std::vector<Pixel>& by_error,
                          const std::function<double(const Pixel&)>& figure) {
  const Means means = means_of_the_first(by_doubt, figure);
  const Means best = means_of_the_first(by_error, figure);
  return {means.at_points, best.at_points, means.area, best.area};
}

/// By error inside of equal doubt: sums then do not depend on where pixels lie in the image.
void sort(std::vector<Pixel>& pixels) {
  std::sort(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) {
    return a.doubt != b.doubt ? a.doubt < b.doubt : a.error < b.error;
  });
}

Sparsification sparsify(std::vector<Pixel> by_doubt, const std::vector<double>& deltas) {
  std::vector<Pixel> by_error = by_doubt;
  for (Pixel& pixel : by_error) pixel.doubt = pixel.error;
  sort(by_doubt);
  sort(by_error);

  Sparsification result;
  result.pixels = static_cast<std::int64_t>(by_doubt.size());
  for (const std::size_t count : counts(by_doubt.size())) {
    result.kept.push_back(static_cast<double>(count) / static_cast<double>(by_doubt.size()));
  }
  result.deltas = deltas;
  for (const double delta : deltas) {
    result.bad.push_back(curve(by_doubt, by_error, [delta](const Pixel& pixel) {
      return pixel.error > delta ? 1.0 : 0.0;
    }));
  }
  result.average_error = curve(by_doubt, by_error, [](const Pixel& pixel) { return pixel.error; });
  return result;
}

void require_sizes(const DisparityMap& map, const cv::Mat1f& truth, const cv::Mat1f& confidence) {
  require_size(truth.size(), map.size(), "truth");
  require_size(confidence.size(), map.size(), "confidence");
}

}  // namespace

Sparsification sparsification(const DisparityMap& map, const cv::Mat1f& truth,
                              const cv::Mat1f& confidence, const EvaluationRules& rules,
                              const cv::Mat1b& mask) {
  require_sizes(map, truth, confidence);
  if (!mask.empty()) require_size(mask.size(), map.size(), "truth mask");
  std::vector<Pixel> pixels = collect(map, truth, confidence, rules, mask);
  if (pixels.empty()) throw Error("no pixel has both a disparity and a truth; check the files");
  return sparsify(std::move(pixels), rules.deltas);
}

std::vector<RegionSparsification> sparsification_by_region(const DisparityMap& map,
                                                           const GroundTruth& truth,
                                                           const cv::Mat1f& confidence,
                                                           const EvaluationRules& rules) {
  require_sizes(map, truth.disparity, confidence);
  std::vector<RegionSparsification> result;
  for (const auto& [name, mask] : regions_of(truth)) {
    std::vector<Pixel> pixels = collect(map, truth.disparity, confidence, rules, mask);
    if (!pixels.empty()) result.push_back({name, sparsify(std::move(pixels), rules.deltas)});
  }
  return result;
}

}  // namespace xgm
