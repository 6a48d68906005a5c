// SPDX-License-Identifier: Apache-2.0
#include "eval/eval_surface.hpp"

#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "command_line/command_line.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
namespace {

std::string line(const char* name, const geo::SurfaceErrors& errors) {
  return fmt::format("{:<12}{:>12.2f} %{:>10.2f} %{:>11.3f}{:>9.2f}{:>15.3f}\n", name,
                     100 * errors.completeness, 100 * errors.coverage, errors.median_error,
                     errors.rmse, errors.signed_median);
}

}  // namespace

int eval_surface(const EvalOptions& options) {
  if (options.truth.empty())
    throw UsageError("eval --surface: give the true heights, --truth FILE");
  const geo::Raster surface = geo::read_raster(options.map);
  const geo::Raster truth = geo::read_raster(options.truth);
  const cv::Mat1f heights = geo::on_grid_of(surface, truth);
  const geo::SurfaceErrors errors = geo::compare_surfaces(heights, truth.values);
  cv::Mat1f level = heights.clone();
  level -= errors.signed_median;
  std::cout << fmt::format("{:<12}{:>14}{:>12}{:>11}{:>9}{:>15}\n", "", "within 1 m", "covered",
                           "|dz| m", "RMSE m", "median dz m")
            << line("as it is", errors)
            << line("levelled", geo::compare_surfaces(level, truth.values))
            << fmt::format("{} cells have a true height; |dz| is the median\n", errors.truth_cells);
  return kOk;
}
#else
int eval_surface(const EvalOptions&) {
  throw UsageError("eval --surface: this program was built without GDAL and PROJ");
}
#endif

}  // namespace xgm::cli
