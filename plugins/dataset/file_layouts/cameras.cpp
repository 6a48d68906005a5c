// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/cameras.hpp"

#include <cmath>

#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"

namespace xgm::dataset {
namespace {

constexpr double kSameFocal = 1e-3;  // of the focal length: half a pixel at the edge of 1000
constexpr double kSameRow = 1;       // px

[[noreturn]] void refuse(const std::string& what, double left, double right, const Camera& base,
                         const Camera& match) {
  throw Error(
      match.place + ": " + what + " of " + match.name + " is " + short_number(right) +
      " but that of " + base.name + " is " + short_number(left) +
      "; the cameras of a rectified pair have one: rectify the images, or correct the file");
}

}  // namespace

void require_rectified(const Camera& left, const Camera& right) {
  if (!(std::abs(left.focal - right.focal) <= kSameFocal * left.focal)) {
    refuse("the focal length", left.focal, right.focal, left, right);
  }
  if (!(std::abs(left.cy - right.cy) <= kSameRow)) refuse("cy", left.cy, right.cy, left, right);
}

}  // namespace xgm::dataset
