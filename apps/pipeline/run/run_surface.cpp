// SPDX-License-Identifier: Apache-2.0
#include "run/run_surface.hpp"

#include "options/scene_request.hpp"
#include "options/surfaces.hpp"
#include "options/values.hpp"
#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>

#include "command_line/command_line.hpp"
#include "terminal/console.hpp"
#include "xgm/geo/run/recorded_surface.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
namespace {

std::optional<cv::Vec4d> parse_area(const std::string& text) {
  if (text.empty()) return std::nullopt;
  cv::Vec4d area;
  const std::vector<std::string> items = split_at_commas(text);
  bool sound = items.size() == 4;
  for (int i = 0; sound && i < 4; ++i) {
    const auto number = parse_number(items[static_cast<std::size_t>(i)]);
    sound = number.has_value();
    if (number) area[i] = *number;
  }
  if (sound && area[0] < area[2] && area[1] < area[3] && std::abs(area[1]) <= 90 &&
      std::abs(area[3]) <= 90) {
    return area;
  }
  throw UsageError(
      "--area " + text +
      ": write WEST,SOUTH,EAST,NORTH in degrees, for example 55.64,-21.24,55.66,-21.22");
}

/// "4.1 % occluded, 0.3 % peak", the most first; "" without empty cells.
std::string empty_cells(const cv::Mat1b& reasons) {
  const auto shares = geo::cell_shares(reasons);
  std::vector<int> order;
  for (int i = 1; i < geo::kCellReasonCount; ++i) {
    if (shares[static_cast<std::size_t>(i)] > 0) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](int a, int b) {
    return shares[static_cast<std::size_t>(a)] > shares[static_cast<std::size_t>(b)];
  });
  std::string text;
  for (const int i : order) {
    text += fmt::format("{}{:.1f} % {}", text.empty() ? "" : ", ",
                        100 * shares[static_cast<std::size_t>(i)],
                        geo::to_string(static_cast<geo::CellReason>(i)));
  }
  return text;
}

std::string truth_line(const geo::SurfaceTruth& truth) {
  if (!truth.surface) return {};
  const geo::SurfaceErrors& errors = *truth.surface;
  return fmt::format(
      "truth:   {:.2f} % within 1 m, {:.2f} % covered, median |dz| {:.3f} m, RMSE {:.2f} m, median "
      "dz {:.3f} m\n",
      100 * errors.completeness, 100 * errors.coverage, errors.median_error, errors.rmse,
      errors.signed_median);
}

void print_summary(const geo::RecordedSurface& run, const std::string& folder) {
  const geo::GridSpec& grid = run.result.grid;
  const std::string empty = run.result.reasons.empty() ? "" : empty_cells(run.result.reasons);
  std::cout << fmt::format("surface: {} x {} cells of {:g} m, {}, {:.1f} % have a height\n",
                           grid.size.width, grid.size.height, grid.place.step_x,
                           geo::crs_name(grid.crs), 100 * run.covered)
            << (empty.empty() ? "" : "empty:   " + empty + "\n") << truth_line(run.truth)
            << fmt::format("cost:    {:.1f} s\nwritten: {}/dsm.tif and its layers, run.json\n",
                           run.seconds, folder);
}

}  // namespace

int run_surface(const Pipeline& pipeline, const Registry& registry,
                const RunCommandOptions& options, const std::vector<std::string>& command_line,
                const RunOptions& run, Progress& progress) {
  const geo::SurfaceFiles files{options.satellite_images, options.dem,
                                options.satellite_masks,  parse_area(options.area),
                                options.satellite_clouds, options.truth};
  geo::SurfaceRecordRequest request{.folder = options.output,
                                    .overrides = parse_overrides(options.assignments),
                                    .command_line = command_line,
                                    .inputs = files_beside_scene(registry, {}, {})};
  request.tell = [&](const std::string& what) { progress.begin(what); };
  const geo::RecordedSurface recorded = geo::record_surface(pipeline, files, request, run);
  progress.end();
  print_summary(recorded, options.output);
  if (recorded.failure.empty()) return kOk;
  log_error(recorded.failure);
  return kFailed;
}
#else
int run_surface(const Pipeline&, const Registry&, const RunCommandOptions&,
                const std::vector<std::string>&, const RunOptions&, Progress&) {
  throw UsageError("this program was built without GDAL and PROJ");
}
#endif

bool is_surface(const Pipeline& pipeline, const RunCommandOptions& options) {
  const bool surface = makes_surfaces(pipeline);
  const bool has_inputs = !options.satellite_images.empty() || !options.satellite_clouds.empty();
  if (surface && !has_inputs) {
    throw UsageError(pipeline.file() +
                     ": makes surfaces of satellite images; give --images FILE "
                     "FILE ..., or --clouds FILE.ply ...");
  }
  if (surface && !options.cloud.empty()) {
    throw UsageError(
        "--cloud is for stereo pairs: a surface's points are always in DIR/cloud.ply; --clouds "
        "FILE.ply ... makes a surface of them again");
  }
  if (!surface && has_inputs) {
    throw UsageError(pipeline.file() +
                     ": matches one pair of images; --images and --clouds are for pipelines of "
                     "type surface, such as dsm_tmgm16");
  }
  if (!surface && !options.area.empty()) {
    throw UsageError("--area: is for pipelines of type surface, such as dsm_tmgm16");
  }
  return surface;
}

}  // namespace xgm::cli
