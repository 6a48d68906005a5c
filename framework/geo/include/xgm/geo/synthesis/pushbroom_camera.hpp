// SPDX-License-Identifier: Apache-2.0
// A camera that sees one line at a time from an orbit: the truth behind generated RPCs.
#pragma once

#include <cstdint>
#include <optional>

#include "xgm/geo/camera/rpc_camera.hpp"

namespace xgm::geo {

struct PushbroomSpec {
  GeoPoint target;        ///< seen in the middle of the image
  double azimuth = 0;     ///< from where it is seen, degrees: north is 0, east 90
  double incidence = 10;  ///< degrees from straight above
  double heading = 190;   ///< to where rows follow each other on the ground, degrees
  double gsd = 0.5;       ///< size of a pixel at the target, across the line of sight, m
  cv::Size size{1000, 1000};
  std::uint64_t seed = 1;  ///< of the attitude's wobble
};

/// On a circular orbit of 694 km above the rotating Earth. The attitude follows a line on the
/// ground, and wobbles by some pixels within seconds; the optics distort by some pixels over
/// 10,000. So no part of the model is affine or rational. It shares no code with RpcCamera. Pixels
/// are (column, row), (0, 0) being the centre of the first. Immutable.
class XGM_API PushbroomCamera {
 public:
  explicit PushbroomCamera(const PushbroomSpec& spec);

  const PushbroomSpec& spec() const { return spec_; }
  /// From the satellite down.
  Ray sight(cv::Point2d pixel) const;
  /// Where a point (ECEF, m) is seen, to 1e-7 px; empty if it is seen in no line near the image.
  std::optional<cv::Point2d> project(const cv::Vec3d& ecef) const;

 private:
  /// Position and attitude when a row is taken. Columns of `axes`: along the detector, along the
  /// flight, and to the ground.
  struct Pose {
    cv::Vec3d position;
    cv::Matx33d axes;
  };
  struct Wobble {
    double amplitude, period, phase;  ///< rad, s, rad
  };
  Pose pose(double row) const;
  cv::Vec3d position(double time) const;
  double angle_of(double column) const;  ///< tangent of the angle to the middle of the detector
  double column_of(double tangent) const;

  PushbroomSpec spec_;
  cv::Vec3d target_, forward_;  // ECEF; unit vector along the rows' progress
  cv::Vec3d above_, flight_;    // unit vectors to the satellite at time 0, and of its flight
  double orbit_ = 0, pixel_angle_ = 0;  // m from the Earth's centre; rad
  double step_ = 0;                     // m on the ground from row to row
  cv::Vec<double, 3> still_;            // rotation of the wobble at time 0
  std::array<Wobble, 3> wobbles_{};
};

}  // namespace xgm::geo
