// SPDX-License-Identifier: Apache-2.0
// Every cell is the mean of the points around its centre, weighted by their distance, as CARS makes
// surfaces: Youssefi, Michel, Sarrazin, Buffe, Cournet, Delvit, L'Helguen, Melet, Emilien, Bosman:
// CARS: a photogrammetry pipeline using Dask graphs to construct a global 3D model (IGARSS 2020).
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "xgm/base/parallel.hpp"
#include "xgm/geo/stage/surface.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Gaussian final : public Surface {
 public:
  struct Parameters {
    double sigma = 1;
    double radius = 3;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("sigma", p.sigma, "Standard deviation of the weights.").unit("cells").range(0.1, 10);
    set.add("radius", p.radius, "Points farther from the centre of a cell have no weight.")
        .unit("cells")
        .range(0.5, 30);
  }

  explicit Gaussian(Parameters parameters) : p_(parameters) {}

  Raster run(const GridPoints& points, const GridSpec& grid, const Context&) const override {
    // Points by the row of cells they lie in; each row of the result looks at those around it.
    std::vector<std::vector<cv::Vec3d>> rows(static_cast<std::size_t>(grid.size.height));
    const int reach = static_cast<int>(std::ceil(p_.radius));
    for (const cv::Vec3d& point : points) {
      const cv::Point2d cell = grid.place.cell({point[0], point[1]});
      const double row = std::floor(cell.y + 0.5);
      if (!std::isfinite(point[2]) || row < -reach || row >= grid.size.height + reach) continue;
      const double kept = std::clamp(row, 0.0, grid.size.height - 1.0);
      rows[static_cast<std::size_t>(kept)].push_back({cell.x, cell.y, point[2]});
    }
    Raster raster{
        cv::Mat1f(grid.size, std::numeric_limits<float>::quiet_NaN()), grid.place, grid.crs, {}};
    parallel_for(0, grid.size.height, [&](int y) { fill_row(rows, y, reach, raster.values); });
    return raster;
  }

 private:
  void fill_row(const std::vector<std::vector<cv::Vec3d>>& rows, int y, int reach,
                cv::Mat1f& values) const {
    std::vector<double> sum(static_cast<std::size_t>(values.cols)), weights(sum.size());
    for (int r = std::max(0, y - reach); r <= std::min(values.rows - 1, y + reach); ++r) {
      for (const cv::Vec3d& point : rows[static_cast<std::size_t>(r)]) {
        const int first = std::max(0, static_cast<int>(std::ceil(point[0] - p_.radius)));
        const int last =
            std::min(values.cols - 1, static_cast<int>(std::floor(point[0] + p_.radius)));
        for (int x = first; x <= last; ++x) {
          const double distance2 = std::pow(point[0] - x, 2) + std::pow(point[1] - y, 2);
          if (distance2 > p_.radius * p_.radius) continue;
          const double weight = std::exp(-distance2 / (2 * p_.sigma * p_.sigma));
          sum[static_cast<std::size_t>(x)] += weight * point[2];
          weights[static_cast<std::size_t>(x)] += weight;
        }
      }
    }
    for (int x = 0; x < values.cols; ++x) {
      const auto i = static_cast<std::size_t>(x);
      if (weights[i] > 0) values(y, x) = static_cast<float>(sum[i] / weights[i]);
    }
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Gaussian>("gaussian",
                         "The mean of the points around each cell's centre, the nearer "
                         "the weightier.");
}
