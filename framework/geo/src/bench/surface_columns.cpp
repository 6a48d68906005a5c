// SPDX-License-Identifier: Apache-2.0
#include "bench/surface_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xgm::geo {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPercent = 100, kMega = 1e6;

void add_errors(std::vector<SurfaceColumn>& columns, SurfaceErrors SurfaceCell::*errors,
                const std::string& key, const std::string& head) {
  const auto add = [&](const std::string& name, const std::string& shown, Best best, double scale,
                       double SurfaceErrors::*figure) {
    columns.push_back(
        {.key = key + name,
         .head = head + shown,
         .best = best,
         .scale = scale,
         .value = [errors, figure](const SurfaceCell& cell) { return cell.*errors.*figure; }});
  };
  add("completeness", "complete", Best::highest, kPercent, &SurfaceErrors::completeness);
  add("median_error_m", "median", Best::lowest, 1, &SurfaceErrors::median_error);
  add("rmse_m", "RMSE", Best::lowest, 1, &SurfaceErrors::rmse);
}

double of_disparities(const SurfaceCell& cell, double Evaluation::*figure) {
  return cell.disparities ? *cell.disparities.*figure : kNone;
}

/// Share of the pixels that have no disparity, or one that is more than `delta` px off.
double total(const SurfaceCell& cell, double delta) {
  if (!cell.disparities) return kNone;
  for (const ThresholdScore& score : cell.disparities->at) {
    if (score.delta == delta) return score.total;
  }
  return kNone;
}

void add_disparities(std::vector<SurfaceColumn>& columns) {
  columns.push_back({.key = "disparity_total_1",
                     .head = "d total 1",
                     .scale = kPercent,
                     .value = [](const SurfaceCell& c) { return total(c, 1); }});
  columns.push_back({.key = "disparity_total_2",
                     .head = "d total 2",
                     .scale = kPercent,
                     .value = [](const SurfaceCell& c) { return total(c, 2); }});
  columns.push_back(
      {.key = "disparity_invalid",
       .head = "d invalid",
       .scale = kPercent,
       .value = [](const SurfaceCell& c) { return of_disparities(c, &Evaluation::invalid); }});
  columns.push_back(
      {.key = "disparity_average_error", .head = "d avg err", .value = [](const SurfaceCell& c) {
         return of_disparities(c, &Evaluation::average_error);
       }});
  columns.push_back({.key = "disparity_rms", .head = "d rms", .value = [](const SurfaceCell& c) {
                       return of_disparities(c, &Evaluation::rms);
                     }});
}

}  // namespace

std::vector<SurfaceColumn> surface_columns() {
  std::vector<SurfaceColumn> columns;
  add_errors(columns, &SurfaceCell::errors, "", "");
  columns.push_back({.key = "signed_median_m",
                     .head = "bias",
                     .best = Best::none,
                     .value = [](const SurfaceCell& c) { return c.errors.signed_median; }});
  columns.push_back({.key = "coverage",
                     .head = "covered",
                     .best = Best::highest,
                     .scale = kPercent,
                     .value = [](const SurfaceCell& c) { return c.errors.coverage; }});
  add_errors(columns, &SurfaceCell::levelled, "levelled_", "lev. ");
  columns.push_back({.key = "spikes",
                     .head = "spikes",
                     .decimals = 3,
                     .scale = kPercent,
                     .value = [](const SurfaceCell& c) { return c.spikes; }});
  add_disparities(columns);
  columns.push_back(
      {.key = "search_px", .head = "search px", .decimals = 1, .value = [](const SurfaceCell& c) {
         return c.search;
       }});
  columns.push_back(
      {.key = "seconds", .head = "s", .value = [](const SurfaceCell& c) { return c.seconds; }});
  columns.push_back({.key = "peak_bytes",
                     .head = "MB",
                     .decimals = 0,
                     .scale = 1 / kMega,
                     .value = [](const SurfaceCell& c) { return c.peak_bytes; },
                     .largest = true});
  return columns;
}

bool knows_disparities(const SurfaceBenchResult& result) {
  return std::any_of(result.cells.begin(), result.cells.end(),
                     [](const SurfaceCell& cell) { return cell.disparities.has_value(); });
}

std::vector<SurfaceColumn> table_columns(const SurfaceBenchResult& result) {
  std::vector<SurfaceColumn> columns = surface_columns();
  const bool disparities = knows_disparities(result);
  std::erase_if(columns, [&](const SurfaceColumn& column) {
    const bool of_disparities = column.key.rfind("disparity_", 0) == 0;
    const bool shown = column.key == "disparity_total_1" || column.key == "disparity_average_error";
    return of_disparities && !(disparities && shown);
  });
  return columns;
}

std::vector<std::string> sets(const SurfaceBenchResult& result) {
  std::vector<std::string> names;
  for (const SurfaceScene& scene : result.request.scenes) {
    if (std::find(names.begin(), names.end(), scene.set) == names.end()) names.push_back(scene.set);
  }
  return names;
}

SurfaceAverage average(const SurfaceBenchResult& result, std::size_t pipeline,
                       const std::string& set, const std::vector<SurfaceColumn>& columns) {
  SurfaceAverage average;
  average.figures.assign(columns.size(), 0);
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    if (result.request.scenes[scene].set != set) continue;
    ++average.of;
    const SurfaceCell& cell = result.at(pipeline, scene);
    if (cell.state != CellState::done) {
      for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
        if (result.at(i, scene).state == CellState::done) average.comparable = false;
      }
      continue;
    }
    ++average.scenes;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = columns[c].value(cell);
      double& figure = average.figures[c];
      figure = columns[c].largest ? std::max(figure, value) : figure + value;
    }
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double count = columns[c].largest ? 1 : static_cast<double>(average.scenes);
    average.figures[c] = average.scenes > 0 ? average.figures[c] / count : kNone;
  }
  return average;
}

}  // namespace xgm::geo
