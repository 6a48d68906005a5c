// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/synthesis/satellite_scene.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/check_spec.hpp"
#include "synthesis/coarse_dem.hpp"
#include "synthesis/photograph.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/synthesis/fit_rpc.hpp"

namespace xgm::geo {
namespace {

struct Extent {
  GridPlace place;
  cv::Size size;
};

HeightInterval rpc_heights(const SatelliteSceneSpec& spec, const HeightInterval& ground) {
  return {ground.min - spec.rpc_below, ground.max + spec.rpc_above};
}

PushbroomSpec camera_spec(const SatelliteSceneSpec& spec, const HeightInterval& ground,
                          std::size_t i) {
  const SatelliteView& view = spec.views[i];
  return {.target = {spec.longitude, spec.latitude, (ground.min + ground.max) / 2},
          .azimuth = view.azimuth,
          .incidence = view.incidence,
          .heading = view.heading,
          .gsd = spec.gsd,
          .size = {spec.size, spec.size},
          .seed = spec.seed * 1000 + i};
}

/// To where a camera sees points of another one's line of sight that are higher, per px.
cv::Point2d epipolar_direction(const PushbroomCamera& camera, const PushbroomCamera& other,
                               const MapFrame& frame, const HeightInterval& heights) {
  const cv::Size size = other.spec().size;
  const Ray sight = other.sight({(size.width - 1) / 2.0, (size.height - 1) / 2.0});
  const auto low = camera.project(frame.at_height(sight, heights.min));
  const auto high = camera.project(frame.at_height(sight, heights.max));
  if (!low || !high || cv::norm(*high - *low) < 1e-6) return {1, 0};
  return (*high - *low) / cv::norm(*high - *low);
}

/// All of the ground that any sight can meet, with a border for the coarse DEM.
Extent ground_extent(const SatelliteSceneSpec& spec, const SatelliteCameras& cameras,
                     const MapFrame& frame) {
  const HeightInterval heights = rpc_heights(spec, cameras.ground);
  cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  constexpr int kSides = 4;
  for (const SatelliteSceneView& view : cameras.views) {
    for (int k = 0; k < (kSides + 1) * (kSides + 1); ++k) {
      const cv::Point2d pixel(spec.size * (k % (kSides + 1)) / double{kSides},
                              spec.size * (k / (kSides + 1)) / double{kSides});
      for (const double height : {heights.min, heights.max}) {
        const cv::Vec3d p = frame.to_map(frame.at_height(view.truth.sight(pixel), height));
        low = {std::min(low.x, p[0]), std::min(low.y, p[1])};
        high = {std::max(high.x, p[0]), std::max(high.y, p[1])};
      }
    }
  }
  const double border = 2 * spec.dem_posting + 20;
  const double left = std::floor((low.x - border) / spec.posting) * spec.posting;
  const double top = std::ceil((high.y + border) / spec.posting) * spec.posting;
  const double width = (high.x + border - left) / spec.posting;
  const double height = (top - low.y + border) / spec.posting;
  if (width * height > 1e9) {
    throw UsageError("the scene's surface would have " + std::to_string(width * height / 1e6) +
                     " million cells; give a smaller size or a larger posting");
  }
  return {{left, top, spec.posting, -spec.posting},
          {static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(height))}};
}

}  // namespace

SatelliteCameras make_satellite_cameras(const SatelliteSceneSpec& spec) {
  check(spec);
  SatelliteCameras cameras{ground_heights(spec), {}};
  const MapFrame frame(spec.longitude, spec.latitude);
  const HeightInterval heights = rpc_heights(spec, cameras.ground);
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    const PushbroomCamera camera(camera_spec(spec, cameras.ground, i));
    const RpcFit fit = fit_rpc(camera.spec().size, heights, [&](cv::Point2d pixel, double height) {
      GeoPoint point = frame.to_geodetic(frame.at_height(camera.sight(pixel), height));
      point.height = height;
      return point;
    });
    cameras.views.push_back({camera, fit.model, fit.model, fit.residual});
  }
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    SatelliteSceneView& view = cameras.views[i];
    const PushbroomCamera& other = cameras.views[i == 0 ? 1 : 0].truth;
    const cv::Point2d along = epipolar_direction(view.truth, other, frame, cameras.ground);
    const cv::Point2d error = spec.views[i].pointing_error;
    view.delivered.column.offset += error.x * along.x - error.y * along.y;
    view.delivered.row.offset += error.x * along.y + error.y * along.x;
  }
  return cameras;
}

SatelliteScene make_satellite_scene(const SatelliteSceneSpec& spec) {
  const SatelliteCameras cameras = make_satellite_cameras(spec);
  const MapFrame frame(spec.longitude, spec.latitude);
  const Extent extent = ground_extent(spec, cameras, frame);
  const Landscape land = make_landscape(spec, extent.place, extent.size);
  SatelliteScene scene{.spec = spec,
                       .ground = cameras.ground,
                       .views = cameras.views,
                       .surface = {land.heights,
                                   land.place,
                                   frame.crs(),
                                   {{"vertical_datum", std::string(kEllipsoidalHeights)}}},
                       .dem = coarse_dem(spec, land, frame),
                       .images = {},
                       .heights = {},
                       .visible = {}};
  const HeightGrid grid(land.heights, land.place);
  const HeightInterval around{cameras.ground.min - 1, cameras.ground.max + 1};
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    const PushbroomCamera& camera = scene.views[i].truth;
    const Photograph photo =
        photograph(spec, static_cast<int>(i), land, grid, Sights(camera, frame, around), frame);
    scene.images.push_back(photo.image);
    scene.heights.push_back(photo.heights);
    scene.visible.push_back(visible_cells(camera, land, grid, frame));
  }
  return scene;
}

}  // namespace xgm::geo
