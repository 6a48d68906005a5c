// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "camera/rpc_metadata.hpp"
#include "ground/gdal.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/synthesis/satellite_scene.hpp"
#include "xgm/io/file.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;
const char* const kRecord = "scene.yaml";
const char* const kAbout =
    "# A generated satellite scene. Its surface is known exactly: truth; visible: 255 where an\n"
    "# image shows a cell of it, 128 where something stands before it, 0 beside the image.\n"
    "# pointing_error is what the camera of an image says minus what is true, px, along its\n"
    "# epipolar lines and across; error and bias of the dem are in m.\n";

void require(bool done, const std::string& file) {
  if (!done) throw Error(file + ": cannot be written: " + QuietGdal::message());
}

/// GeoTIFF of 16 bit with the camera in its tags; complete or not there.
void write_image(const std::string& file, const cv::Mat1w& image, const RpcModel& camera,
                 const SatelliteView& view) {
  GDALAllRegister();
  const QuietGdal quiet;
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  require(driver != nullptr, file);
  const std::string part = file + ".part";
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=2", nullptr};
  {
    const DatasetPtr dataset(driver->Create(part.c_str(), image.cols, image.rows, 1, GDT_UInt16,
                                            const_cast<char**>(options)));
    require(dataset != nullptr, file);
    for (const auto& [name, value] : rpc_metadata(camera)) {
      dataset->SetMetadataItem(name.c_str(), value.c_str(), "RPC");
    }
    dataset->SetMetadataItem("SUN_AZIMUTH", std::to_string(view.sun_azimuth).c_str());
    dataset->SetMetadataItem("SUN_ELEVATION", std::to_string(view.sun_elevation).c_str());
    require(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, image.cols, image.rows,
                                                const_cast<std::uint8_t*>(image.data), image.cols,
                                                image.rows, GDT_UInt16, 0, 0) == CE_None,
            file);
  }
  fs::rename(part, file);
}

YAML::Node record_of(const SatelliteView& view, double residual) {
  YAML::Node node;
  node["azimuth"] = view.azimuth;
  node["incidence"] = view.incidence;
  node["heading"] = view.heading;
  node["sun_azimuth"] = view.sun_azimuth;
  node["sun_elevation"] = view.sun_elevation;
  node["vegetation"] = view.vegetation;
  node["date"] = view.date;
  node["pointing_error"]["along"] = view.pointing_error.x;
  node["pointing_error"]["across"] = view.pointing_error.y;
  node["rpc_residual_px"] = residual;
  return node;
}

YAML::Node record_of(const SatelliteScene& scene) {
  const SatelliteSceneSpec& spec = scene.spec;
  YAML::Node node;
  node["seed"] = spec.seed;
  node["longitude"] = spec.longitude;
  node["latitude"] = spec.latitude;
  node["size"] = spec.size;
  node["gsd"] = spec.gsd;
  node["noise"] = spec.noise;
  node["posting"] = spec.posting;
  node["lowest"] = spec.lowest;
  if (spec.relief_file.empty()) {
    node["relief"] = spec.relief;
    node["flats"] = spec.flats;
    node["buildings"] = spec.buildings;
    node["woods"] = spec.woods;
    node["cars"] = spec.cars;
  } else {
    node["relief_file"] = spec.relief_file;
    node["relief_posting"] = spec.relief_posting;
  }
  node["rpc_below"] = spec.rpc_below;
  node["rpc_above"] = spec.rpc_above;
  node["dem"]["posting"] = spec.dem_posting;
  node["dem"]["error"] = spec.dem_error;
  node["dem"]["bias"] = spec.dem_bias;
  node["dem"]["datum"] = spec.dem_datum;
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    node["views"].push_back(record_of(spec.views[i], scene.views[i].fit_residual));
  }
  return node;
}

/// Only a scene of before may be replaced; its record goes first.
void clear(const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder)) {
    throw UsageError(folder.string() + ": is a file; name a folder for the scene");
  }
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / kRecord)) {
    throw UsageError(folder.string() +
                     ": holds other files than a generated scene; name another "
                     "folder");
  }
  fs::create_directories(folder);
  fs::remove(folder / kRecord);
}

}  // namespace

void write_satellite_scene(const std::string& folder, const SatelliteScene& scene) {
  const fs::path path(folder);
  clear(path);
  const auto file = [&](const std::string& name) { return (path / name).string(); };
  YAML::Node files;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    write_image(file("image_" + number + ".tif"), scene.images[i], scene.views[i].delivered,
                scene.spec.views[i]);
    Raster visible{{}, scene.surface.place, scene.surface.crs, {}};
    scene.visible[i].convertTo(visible.values, CV_32F);
    write_raster(file("visible_" + number + ".tif"), visible);
    files["images"].push_back("image_" + number + ".tif");
    files["visible"].push_back("visible_" + number + ".tif");
  }
  files["dem"] = "dem.tif";
  files["truth"] = "dsm.tif";
  files["generated"] = record_of(scene);
  write_raster(file("dsm.tif"), scene.surface);
  write_raster(file("dem.tif"), scene.dem);
  YAML::Emitter text;
  text.SetDoublePrecision(17);
  text << files;
  write_file(file(kRecord), kAbout + std::string(text.c_str()) + "\n");
}

}  // namespace xgm::geo
