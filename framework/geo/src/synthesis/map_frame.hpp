// SPDX-License-Identifier: Apache-2.0
// The generated landscape's frame: UTM and ellipsoidal heights, related to ECEF by PROJ alone.
#pragma once

#include "xgm/geo/ground/crs.hpp"
#include "xgm/geo/synthesis/pushbroom_camera.hpp"
#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::geo {

class MapFrame {
 public:
  MapFrame(double longitude, double latitude);

  const Crs& crs() const { return crs_; }  ///< horizontal
  cv::Vec3d to_ecef(const cv::Vec3d& map) const { return to_map_.inverse(map); }
  cv::Vec3d to_map(const cv::Vec3d& ecef) const { return to_map_.forward(ecef); }
  GeoPoint to_geodetic(const cv::Vec3d& ecef) const;

  /// Where a line of sight has a height, ECEF.
  cv::Vec3d at_height(const Ray& sight, double height) const;
  /// Degrees to add to an azimuth from north to have one from the grid's y axis, at the middle.
  double azimuth_shift() const { return azimuth_shift_; }

 private:
  Crs crs_;
  CrsTransform to_map_, to_geodetic_;
  double azimuth_shift_ = 0;
};

/// Lines of sight of an image in the map's frame: two points per pixel, at heights that enclose the
/// surface. Exact every 16 px and bilinear in between, which is as good to 1e-4 px, since cameras
/// bend by a pixel within thousands only. Between the two points a line of sight differs from a
/// straight line in the map by a millimetre (the Earth's curvature over 200 m).
class Sights {
 public:
  Sights(const PushbroomCamera& camera, const MapFrame& frame, const HeightInterval& heights);
  struct Segment {
    cv::Vec3d high, low;
  };
  Segment at(cv::Point2d pixel) const;

 private:
  cv::Mat3d high_, low_;
};

}  // namespace xgm::geo
