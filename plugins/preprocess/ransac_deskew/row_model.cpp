// SPDX-License-Identifier: Apache-2.0
#include "plugins/preprocess/ransac_deskew/row_model.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace xgm::ransac_deskew {
namespace {

/// Three different points, drawn without replacement.
std::vector<Correspondence> draw(const std::vector<Correspondence>& points, cv::RNG& random) {
  const int count = static_cast<int>(points.size());
  const int i = random.uniform(0, count);
  int j = i, k = i;
  while (j == i) j = random.uniform(0, count);
  while (k == i || k == j) k = random.uniform(0, count);
  const auto point = [&](int index) { return points[static_cast<std::size_t>(index)]; };
  return {point(i), point(j), point(k)};
}

bool within(const Correspondence& p, const RowModel& model, double threshold) {
  return std::abs(p.dy - model.at(p.x, p.y)) <= threshold;
}

}  // namespace

RowModel fit(const std::vector<Correspondence>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixX3d values(count, 3);  // x, y, dy
  for (Eigen::Index i = 0; i < count; ++i) {
    const Correspondence& p = points[static_cast<std::size_t>(i)];
    values.row(i) << p.x, p.y, p.dy;
  }
  // About the mean, the constant part is separate, and "flattest" does not depend on the origin.
  const Eigen::RowVector3d mean = values.colwise().mean();
  values.rowwise() -= mean;
  const Eigen::Vector2d slope =
      values.leftCols<2>().completeOrthogonalDecomposition().solve(values.col(2));
  return {slope.x(), slope.y(), mean[2] - slope.x() * mean[0] - slope.y() * mean[1]};
}

std::vector<Correspondence> inliers(const std::vector<Correspondence>& points,
                                    const RowModel& model, double threshold) {
  std::vector<Correspondence> found;
  for (const Correspondence& p : points)
    if (within(p, model, threshold)) found.push_back(p);
  return found;
}

std::vector<Correspondence> consensus(const std::vector<Correspondence>& points,
                                      const RansacOptions& options) {
  cv::RNG random(options.seed);
  RowModel best;
  std::ptrdiff_t most = -1;
  for (int i = 0; i < options.iterations; ++i) {
    const RowModel model = fit(draw(points, random));
    const auto votes = std::count_if(points.begin(), points.end(), [&](const Correspondence& p) {
      return within(p, model, options.threshold);
    });
    if (votes > most) {
      most = votes;
      best = model;
    }
  }
  return inliers(points, best, options.threshold);
}

}  // namespace xgm::ransac_deskew
