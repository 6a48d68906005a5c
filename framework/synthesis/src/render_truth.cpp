// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "render.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::synthesis {
namespace {

/// Far above what rounding does to a point, far below any distance between surfaces.
constexpr double kSamePoint = 1e-6;  // px

/// Both views of a scene whose match view is shifted.
class Truth {
 public:
  Truth(const Surfaces& surfaces, const Options& options)
      : surfaces_(surfaces), size_(options.size), shift_(options.faults.vertical) {}

  void row(int y, GeneratedScene& scene) const {
    const auto base_row = in_row(surfaces_, y);
    for (int x = 0; x < size_.width; ++x) {
      const double d = look(base_row, ray_of(false, shift_, x, y)).hit.disparity;
      scene.truth(y, x) = static_cast<float>(d);
      scene.non_occluded(y, x) = seen_in_match(base_row, x, y, d) ? 255 : 0;

      const Ray ray = ray_of(true, shift_, x, y);
      const auto match_row = shift_.a == 0 && ray.y == y ? base_row : in_row(surfaces_, ray.y);
      const double d_match = look(match_row, ray).hit.disparity;
      scene.reverse_truth(y, x) = static_cast<float>(-d_match);
      scene.reverse_non_occluded(y, x) = seen_in_base(match_row, x, ray.y, d_match) ? 255 : 0;
    }
  }

 private:
  bool inside(double x, double y) const {
    return x >= 0 && x <= size_.width - 1 && y >= 0 && y <= size_.height - 1;
  }

  bool seen_in_match(const std::vector<const Surface*>& row, double x, double y, double d) const {
    const double x_match = x - d;
    if (!inside(x_match, y + shift_.at(x_match, y))) return false;
    return look(row, {x_match, 1, y}).hit.disparity <= d + kSamePoint;
  }

  bool seen_in_base(const std::vector<const Surface*>& row, double x_match, double y,
                    double d) const {
    return inside(x_match + d, y) && look(row, {x_match + d, 0, y}).hit.disparity <= d + kSamePoint;
  }

  const Surfaces& surfaces_;
  cv::Size size_;
  VerticalShift shift_;
};

}  // namespace

Ray ray_of(bool match, const VerticalShift& shift, double x, double y) {
  if (!match) return {x, 0, y};
  return {x, 1, (y - shift.a * x - shift.c) / (1 + shift.b)};
}

void render_truth(const Surfaces& surfaces, const Options& options, GeneratedScene& scene) {
  for (cv::Mat1f* map : {&scene.truth, &scene.reverse_truth}) map->create(options.size);
  for (cv::Mat1b* mask : {&scene.non_occluded, &scene.reverse_non_occluded})
    mask->create(options.size);
  const Truth truth(surfaces, options);
  parallel_for(0, options.size.height, [&](int y) { truth.row(y, scene); });
}

}  // namespace xgm::synthesis
