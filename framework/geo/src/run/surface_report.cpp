// SPDX-License-Identifier: Apache-2.0
#include "run/surface_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "run/polar_plot.hpp"
#include "xgm/evaluation/report_page.hpp"
#include "xgm/geo/image/pair_figures.hpp"
#include "xgm/geo/run/relief.hpp"

namespace xgm::geo {
namespace {

using Figure = std::optional<double>;

std::string text_of(const Figure& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "unknown";
}

std::vector<std::pair<std::string, std::string>> facts_of(const RecordedSurface& run) {
  const GridSpec& grid = run.result.grid;
  std::vector<std::pair<std::string, std::string>> facts{
      {"Grid", fmt::format("{} × {} cells of {:g} m", grid.size.width, grid.size.height,
                           grid.place.step_x)},
      {"Coordinates", crs_name(grid.crs)},
      {"Heights above", run.result.fused.heights.metadata.at("vertical_datum")},
      {"Cells with a height", fmt::format("{:.2f} %", 100 * run.covered)},
      {"Time", fmt::format("{:.1f} s", run.seconds)}};
  if (!run.truth.surface) return facts;
  const SurfaceErrors& errors = *run.truth.surface;
  facts.emplace_back("Within 1 m of the truth", fmt::format("{:.2f} %", 100 * errors.completeness));
  facts.emplace_back("Median error", fmt::format("{:.3f} m", errors.median_error));
  facts.emplace_back("RMSE", fmt::format("{:.2f} m", errors.rmse));
  return facts;
}

/// Black where there is none; brighter than all but a hundredth is white.
cv::Mat3b grey_picture(const cv::Mat1f& values) {
  std::vector<float> levels;
  std::ranges::copy_if(values, std::back_inserter(levels), [](float v) { return !std::isnan(v); });
  float white = 1;
  if (!levels.empty()) {
    const auto at = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() * 99 / 100);
    std::ranges::nth_element(levels, at);
    white = std::max(*at, white);
  }
  cv::Mat3b picture(values.size());
  std::ranges::transform(values, picture.begin(), [white](float value) {
    const auto grey = cv::saturate_cast<uchar>(std::isnan(value) ? 0 : 255 * value / white);
    return cv::Vec3b(grey, grey, grey);
  });
  return picture;
}

void add_layers(const SurfaceResult& result, Page& page) {
  page.picture("Heights, shaded", relief_picture(result.fused.heights));
  page.picture("Orthoimage of the first pair", grey_picture(result.orthoimage.values));
  if (result.surfaces.size() > 1) {
    page.numbers("Pairs that have seen a cell", result.fused.count, "pairs", "none");
    page.numbers("How far the pairs disagree", result.fused.spread, "m", "fewer than two pairs");
  }
  page.numbers("Gap between the lines of sight", result.gaps, "m", "unknown");
  page.classes("What heights were made of", result.sources, {"no height", "measured", "filled"});
  if (result.reasons.empty()) return;
  std::vector<std::string> reasons;
  for (int i = 0; i < kCellReasonCount; ++i) {
    reasons.emplace_back(to_string(static_cast<CellReason>(i)));
  }
  page.classes("Why cells are empty", result.reasons, reasons);
}

/// The paper's figure of views and suns.
void add_directions(const std::vector<SatelliteImage>& images, Page& page) {
  std::vector<SkyPoint> views, suns;
  std::vector<std::vector<std::string>> rows;
  double widest = 30;  // degrees
  for (const SatelliteImage& image : images) {
    const auto view = view_of(image);
    const Acquisition& a = image.acquisition;
    if (view) views.push_back({image.name, view->azimuth, view->incidence});
    if (view) widest = std::max(widest, 15 * std::ceil(view->incidence / 15));
    if (a.sun_azimuth && a.sun_elevation) {
      suns.push_back({image.name, *a.sun_azimuth, 90 - *a.sun_elevation});
    }
    rows.push_back(
        {image.name, text_of(view ? Figure(view->azimuth) : std::nullopt, "{:.1f}°"),
         text_of(view ? Figure(view->incidence) : std::nullopt, "{:.1f}°"),
         text_of(a.sun_azimuth, "{:.1f}°"), text_of(a.sun_elevation, "{:.1f}°"),
         text_of(a.cloud_cover ? Figure(100 * *a.cloud_cover) : std::nullopt, "{:.0f} %")});
  }
  page.heading("Images");
  page.html("<div class=\"gallery levels\">" +
            polar_plot("From where the images were taken", views, widest) +
            (suns.empty() ? "" : polar_plot("Where the sun stood", suns, 90)) + "</div>\n");
  page.table({"Image", "View, azimuth", "View, from straight above", "Sun, azimuth",
              "Sun, elevation", "Clouds"},
             rows);
}

void add_pairs(const SurfaceResult& result, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.pairs.size(); ++i) {
    const PairChoice& pair = result.pairs[i];
    const PairFigures figures = pair_figures(result.images[pair.base], result.images[pair.match]);
    const PointCloud& cloud = result.clouds[i];
    rows.push_back({cloud.base + ", " + cloud.match, text_of(figures.convergence, "{:.1f}°"),
                    text_of(figures.days, "{:.1f}"), text_of(figures.sun, "{:.1f}°"),
                    fmt::format("{:.0f} %", 100 * figures.overlap),
                    std::to_string(cloud.points.size()),
                    fmt::format("{:+.2f} m", result.fused.offsets[i])});
  }
  page.heading("Pairs");
  page.table({"Pair", "Convergence", "Days apart", "Suns apart", "Overlap", "Points",
              "Above the fused surface"},
             rows);
}

}  // namespace

std::string surface_report(const std::string& title, const RecordedSurface& run) {
  Page page(title);
  page.facts(facts_of(run));
  page.warnings(run.record);
  add_layers(run.result, page);
  if (!run.result.images.empty()) {
    add_directions(run.result.images, page);
    add_pairs(run.result, page);
  }
  page.record(run.record);
  return page.text();
}

}  // namespace xgm::geo
