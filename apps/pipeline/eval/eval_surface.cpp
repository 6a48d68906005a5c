// SPDX-License-Identifier: Apache-2.0
#include "eval/eval_surface.hpp"

#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <iostream>

#include "command_line/command_line.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
namespace {

std::string line(const std::string& name, const geo::SurfaceErrors& errors) {
  return fmt::format("{:<22}{:>12.2f} %{:>10.2f} %{:>11.3f}{:>9.2f}{:>15.3f}\n", name,
                     100 * errors.completeness, 100 * errors.coverage, errors.median_error,
                     errors.rmse, errors.signed_median);
}

/// "as it is" and with the median taken out.
std::string lines(const std::string& name, const cv::Mat1f& heights, const cv::Mat1f& truth) {
  const geo::SurfaceErrors errors = geo::compare_surfaces(heights, truth);
  cv::Mat1f level = heights.clone();
  level -= errors.signed_median;
  return line("as it is" + name, errors) +
         line("levelled" + name, geo::compare_surfaces(level, truth));
}

/// dsm.tif of a run's folder and its source.tif, or the files that were named.
EvalOptions with_files(EvalOptions options) {
  const std::filesystem::path folder = options.map;
  if (!std::filesystem::is_directory(folder)) return options;
  const std::string surface = (folder / "dsm.tif").string();
  const std::string source = (folder / "source.tif").string();
  if (!std::filesystem::is_regular_file(surface)) {
    throw UsageError(options.map +
                     ": has no dsm.tif; give the output folder of a run that made a "
                     "surface, or the file to judge");
  }
  options.map = surface;
  if (options.source.empty() && std::filesystem::is_regular_file(source)) options.source = source;
  return options;
}

}  // namespace

int eval_surface(const EvalOptions& asked) {
  if (asked.truth.empty()) throw UsageError("eval --surface: give the true heights, --truth FILE");
  const EvalOptions options = with_files(asked);
  geo::Raster surface = geo::read_raster(options.map);
  const geo::Raster truth = geo::read_raster(options.truth);
  const cv::Mat1f heights = geo::on_grid_of(surface, truth);
  std::cout << fmt::format("{:<22}{:>14}{:>12}{:>11}{:>9}{:>15}\n", "", "within 1 m", "covered",
                           "|dz| m", "RMSE m", "median dz m")
            << lines("", heights, truth.values);
  if (!options.source.empty()) {
    geo::remove_filled(surface, geo::read_raster(options.source));
    std::cout << lines(", measured", geo::on_grid_of(surface, truth), truth.values);
  }
  std::cout << fmt::format("{} cells have a true height; |dz| is the median. {}\n",
                           geo::compare_surfaces(heights, truth.values).truth_cells,
                           geo::comparison_text(surface, truth));
  return kOk;
}
#else
int eval_surface(const EvalOptions&) {
  throw UsageError("eval --surface: this program was built without GDAL and PROJ");
}
#endif

}  // namespace xgm::cli
