// SPDX-License-Identifier: Apache-2.0
// Generates satellite images of a landscape whose surface and cameras are known exactly.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/synthesis/pushbroom_camera.hpp"

namespace xgm::geo {

/// One image: from where and under which sun.
struct SatelliteView {
  double azimuth = 0;         ///< of the satellite, degrees: north is 0, east 90
  double incidence = 10;      ///< degrees from straight above, 0 to 50
  double heading = 190;       ///< to where rows follow each other on the ground, degrees
  double sun_azimuth = 150;   ///< degrees
  double sun_elevation = 50;  ///< degrees, 5 to 90
  double vegetation = 1;      ///< brightness of grass and trees at this date
  int date = 0;               ///< images of one date show the same cars
  /// What the RPC says minus what is true, px: x along the epipolar line of the first image's (of
  /// the first one: the second's) pixels, to where points are seen that are higher; y across it, 90
  /// degrees from columns to rows.
  cv::Point2d pointing_error;
};

struct SatelliteSceneSpec {
  std::uint64_t seed = 1;
  double longitude = 6.4, latitude = 45.2;  ///< of the middle, degrees
  int size = 1000;                          ///< of the images in each direction, px
  double gsd = 0.5;                         ///< across the line of sight, m
  std::vector<SatelliteView> views{{.azimuth = 10, .incidence = 8, .pointing_error = {}},
                                   {.azimuth = 190, .incidence = 8, .pointing_error = {}}};
  double noise = 4;  ///< standard deviation, grey levels of 2047

  double posting = 0.5;    ///< of the surface, m
  double lowest = 400;     ///< lowest ground, m above the ellipsoid
  double relief = 100;     ///< highest ground minus lowest, m
  double flats = 0.4;      ///< share of the ground that is flat
  double buildings = 0.5;  ///< share of the lots on flat ground that are built on
  double woods = 0.25;     ///< share of the ground that has trees
  double cars = 0.3;       ///< share of the places on flat ground where a car stands at a date
  /// A raster of heights in place of the generated landscape; may be empty. What stands on its
  /// ground is a roof where it is smooth, else a tree.
  std::string relief_file;
  double relief_posting = 0.3;  ///< of that raster if it has no georeference, m

  double rpc_below = 60, rpc_above = 60;  ///< what the RPCs reach below and above the surface, m
  double dem_posting = 30;                ///< of the coarse DEM, m
  double dem_error = 2, dem_bias = 0;     ///< standard deviation, and what is added, m
  std::string dem_datum = "ellipsoid";    ///< of with_heights()
};

struct SatelliteSceneView {
  PushbroomCamera truth;
  RpcModel exact;           ///< fitted to `truth`
  RpcModel delivered;       ///< with the pointing error
  double fit_residual = 0;  ///< largest distance of `exact` from `truth`, px
};

/// The cameras alone: for tests of geometry on images of any size.
struct SatelliteCameras {
  HeightInterval ground;  ///< that the scene can have, m
  std::vector<SatelliteSceneView> views;
};

struct SatelliteScene {
  SatelliteSceneSpec spec;
  HeightInterval ground;
  std::vector<SatelliteSceneView> views;
  /// UTM, heights above the ellipsoid; bilinear between the centres of cells. This is what the
  /// images show: sights are intersected with it.
  Raster surface;
  Raster dem;                      ///< in its datum
  std::vector<cv::Mat1w> images;   ///< grey levels, 0 to 2047
  std::vector<cv::Mat1f> heights;  ///< of what the centres of the images' pixels show, m
  /// Where each image shows a cell of the surface: 255; 128 where something stands before it; 0
  /// beside the image.
  std::vector<cv::Mat1b> visible;
};

/// Throws UsageError, which names the value that is out of its range.
XGM_API SatelliteCameras make_satellite_cameras(const SatelliteSceneSpec& spec);

/// The same spec gives the same scene for any number of threads. Shadows and occlusion are cast by
/// the surface; what lies beyond its borders casts none. Cars have no height. Throws UsageError.
XGM_API SatelliteScene make_satellite_scene(const SatelliteSceneSpec& spec);

/// image_1.tif, ... (16 bit, with RPC tags as delivered), dsm.tif, visible_1.tif, ..., dem.tif, and
/// scene.yaml with the files' names and all of the spec and the residuals, which is written last.
/// Throws UsageError if the folder holds anything but such a scene.
XGM_API void write_satellite_scene(const std::string& folder, const SatelliteScene& scene);

}  // namespace xgm::geo
