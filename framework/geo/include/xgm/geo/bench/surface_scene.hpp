// SPDX-License-Identifier: Apache-2.0
// Satellite images of a place whose surface is known: what surface pipelines are judged by.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/run/surface_files.hpp"

namespace xgm::geo {

struct SurfaceScene {
  std::string set;     ///< the region; scenes of one set are averaged
  std::string name;    ///< unique in its set
  SurfaceFiles files;  ///< with a truth
};

/// A scene is a folder with the scene.yaml of read_surface_scene(), which names a truth. `folder`
/// is a scene, or holds scenes, which form a set of its name; a scene that is given by itself
/// belongs to the set of the folder around it. In the order of their names. Throws UsageError,
/// which names the file, the place and the remedy.
XGM_API std::vector<SurfaceScene> find_surface_scenes(const std::string& folder);

/// Every two of the scene's images as a scene of their own, named NAME_1_2 by their numbers.
XGM_API std::vector<SurfaceScene> pairs_of(const SurfaceScene& scene);

/// The truth where at least two of the scene's images show it, NaN elsewhere. Throws Error.
XGM_API Raster judged_truth(const SurfaceScene& scene);

}  // namespace xgm::geo
