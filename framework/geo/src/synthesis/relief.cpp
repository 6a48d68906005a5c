// SPDX-License-Identifier: Apache-2.0
#include "synthesis/relief.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/random.hpp"

namespace xgm::geo {
namespace {

constexpr double kLargestBuilding = 60;  // m: what is narrower and higher than its surroundings
constexpr double kStands = 2.5;          // m above the ground: a building or a tree
constexpr double kSmooth = 0.4;          // m, mean deviation from a plane: a roof
constexpr double kNeighbours = 1;        // m around a cell that are compared with it
constexpr double kEven = 0.12;           // m, the same deviation: where cars can stand

/// Cells without a height take that of the last cell before them in the row, or the first after.
bool fill_row(float* row, int columns) {
  const auto known = [](float height) { return std::isfinite(height); };
  float* const first = std::find_if(row, row + columns, known);
  if (first == row + columns) return false;
  std::fill(row, first, *first);
  for (float* cell = first; cell != row + columns; ++cell) {
    if (!known(*cell)) *cell = cell[-1];
  }
  return true;
}

void fill_holes(cv::Mat1f& heights) {
  int known = -1;  // the last row with heights
  for (int y = 0; y < heights.rows; ++y) {
    if (fill_row(heights[y], heights.cols)) {
      if (known < 0) {
        for (int above = 0; above < y; ++above) heights.row(y).copyTo(heights.row(above));
      }
      known = y;
    } else if (known >= 0) {
      heights.row(known).copyTo(heights.row(y));
    }
  }
}

bool in_metres(const Crs& crs) {
  const CrsTransform from_wgs84("EPSG:4326", horizontal(crs));
  const cv::Vec3d a = from_wgs84.inverse({0, 0, 0}), b = from_wgs84.inverse({1, 0, 0});
  return std::abs(b[0] - a[0]) < 1e-3;  // degrees for a step of one unit
}

int mirrored(double position, int length) {
  const int period = 2 * length;
  const int i = (static_cast<int>(std::floor(position)) % period + period) % period;
  return i < length ? i : period - 1 - i;
}

int odd_cells(double metres, double posting) {
  return 2 * std::max(1, static_cast<int>(std::lround(metres / posting / 2))) + 1;
}

/// The ground below buildings and trees: what is left of heights in an opening.
cv::Mat1f ground_below(const cv::Mat1f& heights, double posting) {
  const int side = odd_cells(kLargestBuilding, posting);
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {side, side});
  cv::Mat1f ground;
  cv::morphologyEx(heights, ground, cv::MORPH_OPEN, window, {-1, -1}, 1, cv::BORDER_REPLICATE);
  return ground;
}

/// How far cells deviate from a plane around them, on the average. Of a plane the mean around a
/// cell is the cell itself.
cv::Mat1f roughness(const cv::Mat1f& heights, double posting) {
  const int side = odd_cells(2 * kNeighbours, posting);
  cv::Mat1f mean, deviation;
  cv::blur(heights, mean, {side, side}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::blur(cv::Mat1f(cv::abs(heights - mean)), deviation, {side, side}, {-1, -1},
           cv::BORDER_REPLICATE);
  return deviation;
}

/// Smooth cells and those that share the surroundings of one: up to the walls.
cv::Mat1b smooth_to_the_edge(const cv::Mat1f& rough, double posting) {
  const int side = 2 * odd_cells(2 * kNeighbours, posting) - 1;  // what roughness() looks at
  const cv::Mat1b smooth(rough < kSmooth);
  cv::Mat1b wide;
  cv::dilate(smooth, wide, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return wide;
}

void cover_relief(const SatelliteSceneSpec& spec, Landscape& land) {
  const cv::Mat1f rough = roughness(land.heights, spec.posting);
  const cv::Mat1b stands(land.heights - ground_below(land.heights, spec.posting) > kStands);
  const cv::Mat1b roofs(stands & smooth_to_the_edge(rough, spec.posting));
  land.flat = (rough < kEven) & ~stands;
  land.cover.setTo(static_cast<std::uint8_t>(Cover::tree), stands);
  land.cover.setTo(static_cast<std::uint8_t>(Cover::roof), roofs);
  cv::Mat1i numbers;
  const int count = cv::connectedComponents(roofs, numbers, 4, CV_32S);
  std::vector<float> albedo(static_cast<std::size_t>(count));
  Random random(spec.seed);
  for (float& a : albedo) a = static_cast<float>(random.real(0.2, 0.8));
  for (int y = 0; y < numbers.rows; ++y) {
    for (int x = 0; x < numbers.cols; ++x) {
      land.roofs(y, x) = albedo[static_cast<std::size_t>(numbers(y, x))];
    }
  }
}

}  // namespace

Raster read_relief(const SatelliteSceneSpec& spec) {
  Raster relief = read_raster(spec.relief_file);
  for (float& height : relief.values) {
    if (!std::isfinite(height)) height = NAN;
  }
  fill_holes(relief.values);
  const float lowest = *std::min_element(relief.values.begin(), relief.values.end());
  if (std::isnan(lowest)) throw Error(spec.relief_file + ": has no heights");
  relief.values -= lowest;
  if (relief.crs.empty()) {
    relief.place = {0, 0, spec.relief_posting, -spec.relief_posting};
  } else if (!in_metres(relief.crs)) {
    throw UsageError(spec.relief_file +
                     ": its cells are not measured in metres; reproject it (gdalwarp -t_srs "
                     "EPSG:CODE of a UTM zone)");
  }
  return relief;
}

void take_relief(const SatelliteSceneSpec& spec, Landscape& land) {
  const Raster relief = read_relief(spec);
  const cv::Size size = land.cover.size();
  const double x_scale = spec.posting / relief.place.step_x;
  const double y_scale = spec.posting / -relief.place.step_y;
  const auto height = [&](int x, int y) {
    return double{relief.values(mirrored(y, relief.values.rows), mirrored(x, relief.values.cols))};
  };
  land.heights.create(size);
  parallel_for(0, size.height, [&](int row) {
    for (int column = 0; column < size.width; ++column) {
      const double x = (column - size.width / 2) * x_scale + relief.values.cols / 2;
      const double y = (row - size.height / 2) * y_scale + relief.values.rows / 2;
      const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
      const double u = x - i, v = y - j;
      land.heights(row, column) = static_cast<float>(
          spec.lowest + (1 - v) * ((1 - u) * height(i, j) + u * height(i + 1, j)) +
          v * ((1 - u) * height(i, j + 1) + u * height(i + 1, j + 1)));
    }
  });
  cover_relief(spec, land);
}

}  // namespace xgm::geo
