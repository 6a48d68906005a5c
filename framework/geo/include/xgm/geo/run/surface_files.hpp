// SPDX-License-Identifier: Apache-2.0
// The files that a surface is made of, and what is asked of them.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/io/require_apart.hpp"

namespace xgm::geo {

struct SurfaceFiles {
  std::vector<std::string> images;     ///< at least two; none if there are clouds
  std::vector<std::string> dem{};      ///< of read_dem(); none: no DEM
  std::vector<std::string> masks{};    ///< of the images, in their order; none, or as many
  std::vector<std::string> cameras{};  ///< in place of what the images hold; none, or as many
  std::string area{};                  ///< of parse_area(); empty: what the images show
  int band = 0;                        ///< of all images, from 1 on; 0: the mean of all bands
  /// Clouds of earlier runs in place of images: nothing is matched, the surface is made of them.
  std::vector<std::string> clouds{};
  std::string truth{};  ///< raster of true heights to compare with; empty: none
  /// Of each image, on the truth's grid: 0 where it does not show the cell. None: all cells that
  /// have a true height are judged. Only benches read them.
  std::vector<std::string> visible{};
};

/// The part of the ground that is wanted; what it is not given by is empty.
struct WantedArea {
  std::optional<DegreeBox> box;
  Outline outline;  ///< within the box
  cv::Rect window;  ///< of the first image, px
};

/// "WEST,SOUTH,EAST,NORTH" in degrees, "COLUMN,ROW:WIDTHxHEIGHT" for a window of the first image,
/// or a file of read_outline(). Throws UsageError, which names the text.
XGM_API WantedArea parse_area(const std::string& text);

/// Opens images, cameras, masks and DEM, and finds what is wrong with them and between them. Throws
/// UsageError, which names the file and the remedy.
XGM_API SurfaceRequest read_surface_request(const SurfaceFiles& files);

/// All files that are read.
XGM_API std::vector<NamedFile> files_of(const SurfaceFiles& files);

/// From a scene in YAML: its keys are images, masks, cameras, dem, area, band, truth and visible,
/// as above; paths are relative to the file. Throws UsageError with all its mistakes, each with
/// line and column.
XGM_API SurfaceFiles read_surface_scene(const std::string& file);

}  // namespace xgm::geo
