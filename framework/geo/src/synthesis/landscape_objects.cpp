// SPDX-License-Identifier: Apache-2.0
// Buildings and trees. Each belongs to a place of a lattice and is found again from its key.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "synthesis/landscape.hpp"
#include "xgm/base/random.hpp"

namespace xgm::geo {
namespace {

enum Key : std::uint64_t { kBuildings = 101, kTrees, kWoods };
constexpr double kLot = 38;       // m between buildings
constexpr double kTreeStep = 5;   // m between trees
constexpr double kCanopy = 0.35;  // m, bumps of a tree's crown

/// Calls body(row, column, place) for the cells within `reach` of a place.
template <class Body>
void for_cells(const Landscape& land, cv::Point2d middle, double reach, const Body& body) {
  const cv::Point2d cell = land.place.cell(middle);
  const int radius = static_cast<int>(std::ceil(reach / land.place.step_x));
  const cv::Rect cells =
      cv::Rect(cvRound(cell.x) - radius, cvRound(cell.y) - radius, 2 * radius + 1, 2 * radius + 1) &
      cv::Rect({}, land.heights.size());
  for (int row = cells.y; row < cells.br().y; ++row) {
    for (int column = cells.x; column < cells.br().x; ++column) {
      body(row, column, land.place.centre(column, row) - middle);
    }
  }
}

/// Calls body(key, corner of the lattice's cell) for all that lie in the grid.
template <class Body>
void for_lattice(const Landscape& land, std::uint64_t key, double step, const Body& body) {
  const cv::Size size = land.heights.size();
  const double right = land.place.left + size.width * land.place.step_x;
  const double bottom = land.place.top + size.height * land.place.step_y;
  const auto first = [&](double v) { return static_cast<std::int64_t>(std::floor(v / step)); };
  for (std::int64_t j = first(bottom); j <= first(land.place.top); ++j) {
    for (std::int64_t i = first(land.place.left); i <= first(right); ++i) {
      body(lattice_key(key, i, j),
           cv::Point2d(static_cast<double>(i) * step, static_cast<double>(j) * step));
    }
  }
}

struct Building {
  cv::Point2d middle;
  double cosine, sine;   // of its direction
  double length, width;  // half of them, m
  double height, gable;  // m above the ground, and of the ridge above the eaves
  double albedo;

  /// Height at a place beside the middle; negative outside of the walls.
  double at(cv::Point2d p) const {
    const double a = std::abs(cosine * p.x + sine * p.y), b = std::abs(cosine * p.y - sine * p.x);
    return a > length || b > width ? -1 : height + gable * (1 - b / width);
  }
};

/// Two statements: in which order arguments of a call are evaluated is up to the compiler.
cv::Point2d random_point(Random& random, double low, double high) {
  const double y = random.real(low, high);
  const double x = random.real(low, high);
  return {x, y};
}

Building make_building(Random& random, cv::Point2d lot) {
  const double angle = random.real(0, std::numbers::pi);
  const cv::Point2d aside = random_point(random, 0.4, 0.6);
  Building building{.middle = lot + aside * kLot,
                    .cosine = std::cos(angle),
                    .sine = std::sin(angle),
                    .length = random.real(6, 14),
                    .width = random.real(4, 8),
                    .height = random.real(4, 20),
                    .gable = 0,
                    .albedo = random.real(0.2, 0.8)};
  if (random.real(0, 1) < 0.4) building.gable = random.real(1.5, 4);
  return building;
}

void build(const Building& building, Landscape& land) {
  float low = INFINITY, high = -INFINITY;
  bool flat = true;
  const double reach = building.length + building.width;
  for_cells(land, building.middle, reach, [&](int row, int column, cv::Point2d p) {
    if (building.at(p) < 0) return;
    low = std::min(low, land.heights(row, column));
    high = std::max(high, land.heights(row, column));
    flat = flat && land.flat(row, column) != 0;
  });
  if (!flat || !(high - low < 2)) return;
  for_cells(land, building.middle, reach, [&](int row, int column, cv::Point2d p) {
    const double height = building.at(p);
    if (height < 0) return;
    land.heights(row, column) = high + static_cast<float>(height);
    land.cover(row, column) = static_cast<std::uint8_t>(Cover::roof);
    land.roofs(row, column) = static_cast<float>(building.albedo);
  });
}

void plant(std::uint64_t key, cv::Point2d corner, const cv::Mat1f& ground, Landscape& land) {
  Random random(key);
  const cv::Point2d middle = corner + random_point(random, 0, kTreeStep);
  const double height = random.real(4, 15), radius = random.real(1.8, 3.8);
  for_cells(land, middle, radius, [&](int row, int column, cv::Point2d p) {
    const double inside = 1 - p.dot(p) / (radius * radius);
    if (inside <= 0 || land.cover(row, column) == static_cast<std::uint8_t>(Cover::roof)) return;
    const cv::Point2d place = middle + p;
    const double crown = height * (0.5 + 0.5 * std::sqrt(inside)) +
                         kCanopy * fractal_noise(key, place.x, place.y, 2, 1);
    const float top = ground(row, column) + static_cast<float>(crown);
    land.heights(row, column) = std::max(land.heights(row, column), top);
    land.cover(row, column) = static_cast<std::uint8_t>(Cover::tree);
  });
}

}  // namespace

void add_buildings(const SatelliteSceneSpec& spec, Landscape& land) {
  for_lattice(land, random_bits::mix(spec.seed + kBuildings), kLot,
              [&](std::uint64_t key, cv::Point2d lot) {
                Random random(key);
                if (random.real(0, 1) < spec.buildings) build(make_building(random, lot), land);
              });
}

void add_trees(const SatelliteSceneSpec& spec, Landscape& land) {
  const std::uint64_t key = random_bits::mix(spec.seed + kTrees);
  const std::uint64_t woods = random_bits::mix(spec.seed + kWoods);
  // In groups: where noise is among its lowest.
  const auto group = [&](cv::Point2d p) { return fractal_noise(woods, p.x, p.y, 90, 20); };
  std::vector<double> groups;
  for_lattice(land, key, kTreeStep,
              [&](std::uint64_t, cv::Point2d corner) { groups.push_back(group(corner)); });
  const auto limit = groups.begin() + static_cast<std::ptrdiff_t>(
                                          spec.woods * static_cast<double>(groups.size() - 1));
  std::nth_element(groups.begin(), limit, groups.end());
  const double highest_group = spec.woods > 0 ? *limit : -INFINITY;
  const cv::Mat1f ground = land.heights.clone();
  for_lattice(land, key, kTreeStep, [&](std::uint64_t own, cv::Point2d corner) {
    if (group(corner) <= highest_group) plant(own, corner, ground, land);
  });
}

}  // namespace xgm::geo
