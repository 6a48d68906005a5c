// SPDX-License-Identifier: Apache-2.0
// The linear model of how far rows are out of line, and its robust fit.
#pragma once

#include <cstdint>
#include <vector>

namespace xgm::ransac_deskew {

/// A base key point in row y whose partner lies in column x and row y + dy of the match image.
struct Correspondence {
  double x = 0, y = 0, dy = 0;
};

/// dy(x, y) = a * x + b * y + c: the pixel that belongs at (x, y) of the match image is found at
/// (x, y + dy).
struct RowModel {
  double a = 0, b = 0, c = 0;

  double at(double x, double y) const { return a * x + b * y + c; }
};

struct RansacOptions {
  int iterations = 1000;
  double threshold = 1;  ///< pixels
  std::uint64_t seed = 1;
};

/// Least squares; of all models that fit equally well (points in one line) the flattest. `points`
/// is not empty.
RowModel fit(const std::vector<Correspondence>& points);

/// The points within `threshold` of the model.
std::vector<Correspondence> inliers(const std::vector<Correspondence>& points,
                                    const RowModel& model, double threshold);

/// Fischler, Bolles: Random sample consensus (CACM 1981), with samples of three points. Returns the
/// largest consensus set. `points` holds three at least.
std::vector<Correspondence> consensus(const std::vector<Correspondence>& points,
                                      const RansacOptions& options);

}  // namespace xgm::ransac_deskew
