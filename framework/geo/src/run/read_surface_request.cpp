// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/footprint.hpp"
#include "xgm/geo/run/surface_files.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;

void require_one_each(const std::string& what, std::size_t count, std::size_t images) {
  if (count == 0 || count == images) return;
  throw UsageError(what + ": there are " + std::to_string(count) + " for " +
                   std::to_string(images) + " images; give one for each, in their order, or none");
}

/// By their names, before anything is opened.
void check(const SurfaceFiles& files) {
  const std::size_t count = files.images.size();
  if (count < 2) {
    throw UsageError("images: " + (count == 1 ? files.images.front() + " is one; " : "") +
                     "give at least two satellite images of the same ground, blanks between them");
  }
  require_one_each("masks", files.masks.size(), count);
  require_one_each("cameras", files.cameras.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const std::string &a = files.images[k], &b = files.images[i];
      std::error_code unknown;
      if (fs::equivalent(a, b, unknown)) {
        throw UsageError(b + ": this image is given twice; a surface needs two views");
      }
      if (fs::path(a).stem() == fs::path(b).stem()) {
        throw UsageError(b + ": " + a +
                         " has the same name, by which results are called; rename one");
      }
    }
  }
}

void check_band(SatelliteImage& image, int band) {
  if (band > image.bands) {
    throw UsageError(image.file + ": has " + std::to_string(image.bands) +
                     (image.bands == 1 ? " band" : " bands") + ", no band " + std::to_string(band) +
                     "; choose another (--band)");
  }
  if (band > 0) image.band = band;
}

/// Means of other bands are grey levels of other colours.
void check_bands(const std::vector<SatelliteImage>& images) {
  const SatelliteImage& first = images.front();
  for (const SatelliteImage& image : images) {
    if (image.bands == first.bands) continue;
    throw UsageError(image.file + ": has " + std::to_string(image.bands) + " bands, but " +
                     first.file + " has " + std::to_string(first.bands) +
                     "; say which band of both is to be matched (--band N)");
  }
}

void check_mask(const SatelliteImage& image) {
  if (image.mask.empty()) return;
  const cv::Size size = read_raster_head(image.mask).size;
  if (size == image.size) return;
  const auto text = [](cv::Size s) {
    return std::to_string(s.width) + " x " + std::to_string(s.height) + " px";
  };
  throw UsageError(image.mask + ": this mask has " + text(size) + ", but " + image.file + " has " +
                   text(image.size) + "; give a mask of the image's size");
}

/// What all images show, for any height that their cameras were made for.
DegreeBox ground_of(const std::vector<SatelliteImage>& images) {
  std::optional<DegreeBox> all;
  for (const SatelliteImage& image : images) {
    const auto box = footprint(image, cv::Rect({}, image.size), image.camera.heights());
    if (!box) {
      throw UsageError(image.file +
                       ": its camera reaches no ground in the image; is the RPC that of another "
                       "image?");
    }
    if (!all) all = box;
    for (int i = 0; i < 4; ++i) {
      (*all)[i] = i < 2 ? std::min((*all)[i], (*box)[i]) : std::max((*all)[i], (*box)[i]);
    }
  }
  return *all;
}

void check_window(const WantedArea& area, const SatelliteImage& first) {
  if (area.window.empty() || (area.window & cv::Rect({}, first.size)) == area.window) return;
  throw UsageError("area: the window ends at column " + std::to_string(area.window.br().x) +
                   ", row " + std::to_string(area.window.br().y) + ", but " + first.file + " has " +
                   std::to_string(first.size.width) + " x " + std::to_string(first.size.height) +
                   " px; choose a smaller window");
}

SurfaceRequest read(const SurfaceFiles& files) {
  check(files);
  const WantedArea area = parse_area(files.area);
  SurfaceRequest request{
      .images = {}, .area = area.box, .outline = area.outline, .window = area.window};
  for (std::size_t i = 0; i < files.images.size(); ++i) {
    SatelliteImage image =
        open_image(files.images[i], files.cameras.empty() ? "" : files.cameras[i]);
    if (!files.masks.empty()) image.mask = files.masks[i];
    check_band(image, files.band);
    check_mask(image);
    request.images.push_back(std::move(image));
  }
  if (files.band == 0) check_bands(request.images);
  check_window(area, request.images.front());
  const DegreeBox ground = ground_of(request.images);
  if (!files.dem.empty()) request.dem = read_dem(files.dem, ground);
  return request;
}

}  // namespace

SurfaceRequest read_surface_request(const SurfaceFiles& files) {
  try {
    return read(files);
  } catch (const Error& error) {
    throw UsageError(error.message());  // whatever stands in the way, nothing has been matched
  }
}

namespace {

/// What GDAL reads with a raster: cameras and metadata beside it, what a VRT is made of.
std::vector<std::string> files_beside(const std::string& raster) {
  std::vector<std::string> files;
  try {
    files = files_of_raster(raster);
  } catch (const Error&) {
    return {};  // whoever reads it says what is wrong
  }
  std::erase(files, raster);
  return files;
}

}  // namespace

std::vector<NamedFile> files_of(const SurfaceFiles& files) {
  std::vector<NamedFile> read;
  const auto add = [&](const std::string& what, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (!name.empty()) read.push_back({what, name});
    }
  };
  const auto add_rasters = [&](const std::string& what, const std::vector<std::string>& names) {
    add(what, names);
    for (const std::string& name : names) add("file of the " + what, files_beside(name));
  };
  add_rasters("image", files.images);
  add_rasters("mask", files.masks);
  add("camera", files.cameras);
  add("cloud", files.clouds);
  add_rasters("truth", {files.truth});
  add_rasters("DEM", dem_files(files.dem));
  if (is_there(files.area)) add("area", {files.area});
  return read;
}

}  // namespace xgm::geo
