// SPDX-License-Identifier: Apache-2.0
// A surface of the ground: one height for each place, or none.
#pragma once

#include <optional>

#include "xgm/base/export.hpp"

namespace xgm::geo {

/// Of an interval of heights, m above the ellipsoid.
struct HeightInterval {
  double min = 0;
  double max = 0;
};

/// Safe to use from several threads.
class XGM_API HeightField {
 public:
  virtual ~HeightField();
  /// m above the WGS 84 ellipsoid; empty where the field has no data. Degrees.
  virtual std::optional<double> height(double longitude, double latitude) const = 0;
  /// Bounds of all its heights.
  virtual HeightInterval bounds() const = 0;
  /// Distance of its samples, m.
  virtual double posting() const = 0;
};

}  // namespace xgm::geo
