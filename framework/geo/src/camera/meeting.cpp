// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/camera/meeting.hpp"

#include <limits>

namespace xgm::geo {

Meeting meet(const Ray& a, const Ray& b) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const cv::Vec3d between = b.origin - a.origin;
  const double cosine = a.direction.dot(b.direction);
  const double determinant = 1 - cosine * cosine;
  if (determinant < 1e-12) return {{kNone, kNone, kNone}, kNone};
  const double along_a = between.dot(a.direction), along_b = between.dot(b.direction);
  const cv::Vec3d on_a = a.origin + a.direction * ((along_a - cosine * along_b) / determinant);
  const cv::Vec3d on_b = b.origin + b.direction * ((cosine * along_a - along_b) / determinant);
  return {(on_a + on_b) * 0.5, cv::norm(on_a - on_b)};
}

}  // namespace xgm::geo
