// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/evaluation/surface_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// NaN if there are none.
double median(std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 != 0) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::string size_text(const cv::Mat1f& values) {
  return std::to_string(values.cols) + " x " + std::to_string(values.rows);
}

/// Bilinear; at the centre of a cell that cell alone.
float at(const cv::Mat1f& values, cv::Point2d cell) {
  const int x = static_cast<int>(std::floor(cell.x)), y = static_cast<int>(std::floor(cell.y));
  const double u = cell.x - x, v = cell.y - y;
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = x + k % 2, row = y + k / 2;
    const double weight = (k % 2 != 0 ? u : 1 - u) * (k / 2 != 0 ? v : 1 - v);
    if (weight < 1e-9) continue;
    if (column < 0 || row < 0 || column >= values.cols || row >= values.rows) return kNone;
    sum += weight * double{values(row, column)};
  }
  return static_cast<float>(sum);
}

/// What the coordinates and heights of the two are of.
struct Systems {
  Crs surface, truth;
  bool with_datum() const { return has_heights(surface) && has_heights(truth); }
};

/// Empty if neither has a georeference.
std::optional<Systems> systems_of(const Raster& surface, const Raster& truth) {
  if (surface.crs.empty() && truth.crs.empty()) return std::nullopt;
  if (surface.crs.empty() || truth.crs.empty()) {
    throw UsageError(
        "only one of the surface and the truth has a georeference; give both one, or "
        "compare them cell by cell without");
  }
  return Systems{crs_with_heights(surface.crs, surface.metadata),
                 crs_with_heights(truth.crs, truth.metadata)};
}

}  // namespace

SurfaceErrors compare_surfaces(const cv::Mat1f& surface, const cv::Mat1f& truth, double threshold) {
  if (surface.size() != truth.size()) {
    throw UsageError("the surface has " + size_text(surface) + " cells, the truth " +
                     size_text(truth) + "; without a georeference they must be on one grid");
  }
  SurfaceErrors errors;
  std::vector<double> signed_errors, sizes;
  double squares = 0;
  std::int64_t complete = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (!std::isfinite(truth(y, x))) continue;
      ++errors.truth_cells;
      if (!std::isfinite(surface(y, x))) continue;
      const double dz = double{surface(y, x)} - double{truth(y, x)};
      signed_errors.push_back(dz);
      sizes.push_back(std::abs(dz));
      squares += dz * dz;
      complete += std::abs(dz) < threshold;
    }
  }
  const auto share = [&](std::int64_t part) {
    return errors.truth_cells > 0
               ? static_cast<double>(part) / static_cast<double>(errors.truth_cells)
               : std::numeric_limits<double>::quiet_NaN();
  };
  errors.cells = static_cast<std::int64_t>(sizes.size());
  errors.completeness = share(complete);
  errors.coverage = share(errors.cells);
  errors.rmse = std::sqrt(squares / static_cast<double>(errors.cells));
  errors.median_error = median(sizes);
  errors.signed_median = median(signed_errors);
  return errors;
}

void remove_filled(Raster& surface, const Raster& source) {
  if (surface.values.size() != source.values.size()) {
    throw UsageError("the surface has " + size_text(surface.values) + " cells, its sources " +
                     size_text(source.values) + "; give source.tif of the same run");
  }
  constexpr auto kFilled = static_cast<float>(HeightSource::filled);
  surface.values.setTo(kNone, source.values == kFilled);
}

Json to_json(const SurfaceErrors& errors) {
  // JSON has no NaN: it writes null.
  return {{"truth_cells", errors.truth_cells},      {"cells", errors.cells},
          {"completeness", errors.completeness},    {"coverage", errors.coverage},
          {"median_error_m", errors.median_error},  {"rmse_m", errors.rmse},
          {"signed_median_m", errors.signed_median}};
}

cv::Mat1f on_grid_of(const Raster& surface, const Raster& truth) {
  const std::optional<Systems> systems = systems_of(surface, truth);
  if (!systems) return surface.values;
  const bool with_datum = systems->with_datum();
  const CrsTransform to_surface(with_datum ? systems->truth : horizontal(systems->truth),
                                with_datum ? systems->surface : horizontal(systems->surface));
  cv::Mat1f values(truth.values.size(), kNone);
  parallel_for(0, values.rows, [&](int row) {
    for (int column = 0; column < values.cols; ++column) {
      const cv::Point2d centre = truth.place.centre(column, row);
      const cv::Vec3d place = to_surface.forward({centre.x, centre.y, 0});
      const float height = at(surface.values, surface.place.cell({place[0], place[1]}));
      if (std::isnan(height)) continue;
      values(row, column) =
          with_datum
              ? static_cast<float>(to_surface.inverse({place[0], place[1], double{height}})[2])
              : height;
    }
  });
  return values;
}

std::string comparison_text(const Raster& surface, const Raster& truth) {
  const std::optional<Systems> systems = systems_of(surface, truth);
  if (!systems) return "Neither has a georeference: compared cell by cell.";
  const std::string place = "The surface is resampled bilinearly to the truth's cells (" +
                            crs_name(horizontal(systems->truth)) + "); ";
  if (systems->with_datum()) {
    const std::string from = heights_name(systems->surface), to = heights_name(systems->truth);
    return place + (from == to ? "heights of both: " + to + "."
                               : "its heights (" + from + ") become the truth's (" + to + ").");
  }
  const auto said = [](const Crs& crs) {
    return has_heights(crs) ? heights_name(crs) : std::string("not said");
  };
  return place +
         "heights are compared as they are, because what they are above is not known of both: " +
         "surface " + said(systems->surface) + ", truth " + said(systems->truth) + ".";
}

}  // namespace xgm::geo
