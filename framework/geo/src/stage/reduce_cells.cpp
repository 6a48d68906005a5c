// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/reduce_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {

double median(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 != 0) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

Raster reduce_cells(const GridPoints& points, const GridSpec& grid,
                    const std::function<double(std::span<double>)>& reduce) {
  const auto cells =
      static_cast<std::size_t>(grid.size.width) * static_cast<std::size_t>(grid.size.height);
  // Of each point; cells + 1 for those beside the grid.
  std::vector<std::size_t> cell_of(points.size(), cells);
  std::vector<std::size_t> begin(cells + 2, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2d cell = grid.place.cell({points[i][0], points[i][1]});
    const double column = std::floor(cell.x + 0.5), row = std::floor(cell.y + 0.5);
    const bool inside = column >= 0 && row >= 0 && column < grid.size.width &&
                        row < grid.size.height && std::isfinite(points[i][2]);
    if (inside) {
      cell_of[i] = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.size.width) +
                   static_cast<std::size_t>(column);
    }
    ++begin[cell_of[i] + 1];
  }
  for (std::size_t c = 0; c <= cells; ++c) begin[c + 1] += begin[c];
  std::vector<double> heights(points.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) heights[next[cell_of[i]]++] = points[i][2];

  Raster raster{
      cv::Mat1f(grid.size, std::numeric_limits<float>::quiet_NaN()), grid.place, grid.crs, {}};
  parallel_for(0, grid.size.height, [&](int row) {
    for (int column = 0; column < grid.size.width; ++column) {
      const std::size_t c =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.size.width) +
          static_cast<std::size_t>(column);
      if (begin[c] == begin[c + 1]) continue;
      raster.values(row, column) =
          static_cast<float>(reduce(std::span(heights).subspan(begin[c], begin[c + 1] - begin[c])));
    }
  });
  return raster;
}

}  // namespace xgm::geo
