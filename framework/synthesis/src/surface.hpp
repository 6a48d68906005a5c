// SPDX-License-Identifier: Apache-2.0
// A shape with what it looks like, and what is seen along a ray.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "shape.hpp"

namespace xgm::synthesis {

using Levels = std::array<double, 3>;  ///< blue, green, red; the first alone of grey images

/// Grey levels as a continuous function of a point of the surface.
struct Texture {
  enum class Kind { plain, noise, bricks, letters, mosaic, wood };
  Kind kind = Kind::plain;
  std::uint64_t key = 0;
  Levels level{128, 128, 128};  ///< mean of each image plane
  double contrast = 160;
  double scale = 1;  ///< size of bricks and letters; 1 suits images 480 px high
  double weak = 0;   ///< of Faults; likewise the next three
  double weak_share = 0;
  double repetitive = 0;
  double period = 12;

  /// `at` in px.
  Levels at(cv::Point2d at, int channels) const;
};

struct Surface {
  Shape shape;
  Texture texture;
  bool lit = false;  ///< has shading, and texture that both views see equally foreshortened

  Levels colour(const Hit& hit, const Ray& ray, int channels) const;
};

/// What a ray meets first.
struct Sight {
  const Surface* surface = nullptr;
  Hit hit;
};

/// The surfaces of a scene; the first ones cover everything.
using Surfaces = std::vector<Surface>;

/// Those that a row of rays may meet.
std::vector<const Surface*> in_row(const Surfaces& surfaces, double y);

/// Of the surfaces given, the nearest one on the ray.
Sight look(const std::vector<const Surface*>& surfaces, const Ray& ray);

}  // namespace xgm::synthesis
