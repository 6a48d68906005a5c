// SPDX-License-Identifier: Apache-2.0
#include "run/run_surface.hpp"

#include "options/scene_request.hpp"
#include "run/summary.hpp"
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
            << reused_line(run.reused, run.reused_from)
            << fmt::format("cost:    {:.1f} s\nwritten: {}/dsm.tif and its layers, run.json\n",
                           run.seconds, folder);
}

}  // namespace

int run_surface(const Pipeline& pipeline, const Registry& registry,
                const RunCommandOptions& options, const KeepRequest& keep,
                const std::vector<std::string>& command_line, const RunOptions& run,
                Progress& progress) {
  geo::SurfaceFiles files = surface_files(options.scene, options.satellites);
  if (!options.clouds.empty()) files.clouds = options.clouds;
  if (!options.truth.empty()) files.truth = options.truth;
  geo::SurfaceRecordRequest request{.folder = options.output,
                                    .report = options.report,
                                    .geoid = options.geoid,
                                    .overrides = parse_overrides(options.assignments),
                                    .command_line = command_line,
                                    .inputs = files_beside_scene(registry, {}, {}),
                                    .keep = keep};
  if (!options.scene.empty()) request.inputs.push_back({"scene", options.scene});
  request.tell = [&](const std::string& what) { progress.begin(what); };
  const geo::RecordedSurface recorded = geo::record_surface(pipeline, files, request, run);
  progress.end();
  print_summary(recorded, options.output);
  if (recorded.failure.empty()) return kOk;
  log_error(recorded.failure);
  return kFailed;
}
#else
int run_surface(const Pipeline&, const Registry&, const RunCommandOptions&, const KeepRequest&,
                const std::vector<std::string>&, const RunOptions&, Progress&) {
  throw UsageError("this program was built without GDAL and PROJ");
}
#endif

}  // namespace xgm::cli
