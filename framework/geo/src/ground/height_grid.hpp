// SPDX-License-Identifier: Apache-2.0
// Where a straight line first meets a surface that is bilinear between the centres of cells.
#pragma once

#include <optional>

#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

class HeightGrid {
 public:
  /// Heights of all cells.
  HeightGrid(const cv::Mat1f& heights, const GridPlace& place);

  /// Share of the way from `from` to `to`, in the map's frame, at which the line comes to lie below
  /// the surface; empty if it does not within the grid. Exact: in each cell it solves the quadratic
  /// equation of the line and the bilinear patch. Ramsey, Potter, Hansen: Ray bilinear patch
  /// intersections (Journal of Graphics Tools 2004).
  std::optional<double> first_hit(const cv::Vec3d& from, const cv::Vec3d& to) const;

  struct Point {
    double height = 0;
    double slope_x = 0, slope_y = 0;  ///< to the east and to the north
  };
  /// Clamped to the grid.
  Point at(double x, double y) const;
  double highest() const { return highest_; }

 private:
  static constexpr int kBlock = 16;
  struct Patch {  // of a cell: h + u * hu + v * hv + u * v * huv
    double h, hu, hv, huv;
  };
  Patch patch(int i, int j) const;
  std::optional<double> hit_in(int i, int j, const cv::Vec3d& from, const cv::Vec3d& way,
                               double begin, double end) const;

  cv::Mat1f heights_;
  cv::Mat1f block_;  // highest of each block of cells
  GridPlace place_;
  double highest_ = 0;
};

}  // namespace xgm::geo
