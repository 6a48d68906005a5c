// SPDX-License-Identifier: Apache-2.0
// What the comments of a PLY say of its points.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "xgm/geo/image/point_cloud.hpp"

namespace xgm::geo {

struct CloudComments {
  Crs crs;                     ///< empty: nothing says it
  std::string vertical_datum;  ///< empty: nothing says it
  double resolution = 0;
  std::map<std::size_t, std::pair<std::string, std::string>> pairs;  ///< names of the images
};

std::vector<std::string> comments_of(const Crs& crs, double resolution,
                                     const std::vector<PointCloud>& pairs);
/// What is not understood says nothing.
CloudComments understand(const std::vector<std::string>& comments);

}  // namespace xgm::geo
