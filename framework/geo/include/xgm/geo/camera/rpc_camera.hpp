// SPDX-License-Identifier: Apache-2.0
// A satellite camera: between pixels and the ground.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <span>

#include "xgm/geo/camera/rpc_model.hpp"
#include "xgm/geo/ground/coordinates.hpp"
#include "xgm/geo/ground/height_field.hpp"

namespace xgm::geo {

/// A line of sight, from high to low, m in ECEF.
struct Ray {
  cv::Vec3d origin;
  cv::Vec3d direction;  ///< of length 1
};

/// From where a pixel is seen, degrees. North is azimuth 0, east 90; straight above is incidence 0.
struct ViewAngles {
  double azimuth = 0;
  double incidence = 0;
};

/// Projections of a camera given by rational polynomials. Grodecki and Dial: Block adjustment of
/// high-resolution satellite images described by rational polynomials (PE&RS 2003), Eq. 1 to 6.
/// Pixels are (column, row), (0, 0) being the centre of the first. Immutable.
class XGM_API RpcCamera {
 public:
  explicit RpcCamera(const RpcModel& model) : model_(model) {}

  const RpcModel& model() const { return model_; }
  /// The heights that the model was made for.
  HeightInterval heights() const;
  /// The heights of which localize() finds points, which is more.
  HeightInterval reach() const;
  /// Whether the model was made for this point: it lies within its scales, and `slack` of them.
  bool covers(const GeoPoint& point, double slack = 0.1) const;

  cv::Point2d project(const GeoPoint& point) const;
  /// The point of that height that is seen in a pixel, to 1e-8 px. Empty if there is none: Newton's
  /// iteration does not converge, or leaves what the model was made for.
  std::optional<GeoPoint> localize(cv::Point2d pixel, double height) const;
  /// The first point of a surface that the line of sight meets, coming from above. Empty if it
  /// meets none, or leaves the surface's data before.
  std::optional<GeoPoint> localize(cv::Point2d pixel, const HeightField& surface) const;

  /// Many points at once, on the threads of the run; each the same as alone.
  void project(std::span<const GeoPoint> points, std::span<cv::Point2d> pixels) const;
  /// `found[i]` is 0 where there is no such point. Returns how many were found.
  std::size_t localize(std::span<const cv::Point2d> pixels, std::span<const double> heights,
                       std::span<GeoPoint> points, std::span<std::uint8_t> found) const;

  /// The line of sight of a pixel, through its points at the ends of heights(). Empty if one of
  /// these cannot be found.
  std::optional<Ray> ray(cv::Point2d pixel) const;
  /// Empty if there is no ray.
  std::optional<ViewAngles> view_angles(cv::Point2d pixel) const;

  /// The camera of an image whose pixel (0, 0) is this one's pixel `origin`.
  RpcCamera cropped(cv::Point2d origin) const;
  /// The camera of an image each of whose pixels is `by` x `by` of this one's.
  RpcCamera reduced(int by) const;

 private:
  RpcModel model_;
};

/// Angle between two lines of sight, degrees.
XGM_API double angle_between(const Ray& a, const Ray& b);

/// Heights that both cameras were made for.
XGM_API HeightInterval common_heights(const RpcCamera& a, const RpcCamera& b);

}  // namespace xgm::geo
