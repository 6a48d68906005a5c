// SPDX-License-Identifier: Apache-2.0
#include "run/surface_outputs.hpp"

#include <algorithm>
#include <filesystem>

#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/geo/image/pair_figures.hpp"
#include "xgm/geo/run/relief.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::geo {
namespace {

constexpr std::array kLayers{"dsm.tif",    "pairs.tif",      "spread.tif", "gap.tif",
                             "source.tif", "orthoimage.tif", "dsm.png"};
constexpr std::array kOfImages{"reasons.tif", "cloud.ply"};
constexpr std::array kSources{"none", "measured", "filled"};

std::string camera_file(const std::string& image) {
  return std::filesystem::path(image).stem().string() + "_rpc.txt";
}

Raster layer(const SurfaceResult& result, const cv::Mat1f& values) {
  return {values, result.grid.place, result.grid.crs, {}};
}

/// `name(i)` is what the code i means.
template <class Name>
LabelRaster labels(const SurfaceResult& result, const cv::Mat1b& values, int codes,
                   const Name& name) {
  LabelRaster raster{values, result.grid.place, result.grid.crs, {}};
  for (int i = 0; i < codes; ++i) raster.metadata["code_" + std::to_string(i)] = name(i);
  return raster;
}

Json known(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string reason_name(int code) { return std::string(to_string(static_cast<CellReason>(code))); }

std::string source_name(int code) { return kSources[static_cast<std::size_t>(code)]; }

}  // namespace

std::vector<std::string> output_names(const SurfaceFiles& files) {
  std::vector<std::string> names(kLayers.begin(), kLayers.end());
  if (files.clouds.empty()) names.insert(names.end(), kOfImages.begin(), kOfImages.end());
  for (const std::string& image : files.images) names.push_back(camera_file(image));
  return names;
}

std::vector<std::string> optional_names() {
  return std::vector<std::string>(kOfImages.begin(), kOfImages.end());
}

void write_outputs(const SurfaceResult& result, const RunFolder& folder) {
  // GeoTIFF has no projected CRS of three dimensions: what heights are counted from is metadata.
  const Raster& heights = result.fused.heights;
  write_raster(folder.file("dsm.tif"), heights);
  write_raster(folder.file("pairs.tif"), layer(result, result.fused.count));
  write_raster(folder.file("spread.tif"), layer(result, result.fused.spread));
  write_raster(folder.file("gap.tif"), layer(result, result.gaps));
  write_labels(folder.file("source.tif"),
               labels(result, result.sources, static_cast<int>(kSources.size()), source_name));
  write_raster(folder.file("orthoimage.tif"), layer(result, result.orthoimage.values));
  write_png(folder.file("dsm.png"), relief_picture(heights));
  for (const SatelliteImage& image : result.images) {
    write_file(folder.file(camera_file(image.file)), rpc_text(image.camera.model()));
  }
  if (result.reasons.empty()) return;
  write_labels(folder.file("reasons.tif"),
               labels(result, result.reasons, kCellReasonCount, reason_name));
  write_clouds(folder.file("cloud.ply"), result.grid.crs, result.grid.place.step_x, result.clouds);
}

Json grid_json(const GridSpec& grid, const Raster& heights) {
  const std::optional<int> epsg = epsg_code(grid.crs);
  return {{"crs", crs_name(grid.crs)},
          {"epsg", epsg ? Json(*epsg) : Json()},
          {"left", grid.place.left},
          {"top", grid.place.top},
          {"resolution_m", grid.place.step_x},
          {"columns", grid.size.width},
          {"rows", grid.size.height},
          {"heights_above", heights.metadata.at("vertical_datum")}};
}

Json images_json(const SurfaceResult& result) {
  Json images = Json::array();
  for (const SatelliteImage& image : result.images) {
    const auto view = view_of(image);
    const Acquisition& a = image.acquisition;
    Json json{{"name", image.name}, {"file", image.file}};
    json["azimuth_deg"] = view ? Json(view->azimuth) : Json();
    json["incidence_deg"] = view ? Json(view->incidence) : Json();
    json["sun_azimuth_deg"] = known(a.sun_azimuth);
    json["sun_elevation_deg"] = known(a.sun_elevation);
    json["time_s"] = known(a.time);
    json["cloud_cover"] = known(a.cloud_cover);
    images.push_back(std::move(json));
  }
  return images;
}

Json pairs_json(const SurfaceResult& result) {
  Json pairs = Json::array();
  for (std::size_t i = 0; i < result.clouds.size(); ++i) {
    Json json{{"base", result.clouds[i].base},
              {"match", result.clouds[i].match},
              {"points", result.clouds[i].points.size()},
              {"above_fused_m", result.fused.offsets[i]}};
    if (!result.images.empty()) {
      const PairChoice& pair = result.pairs[i];
      const PairFigures figures = pair_figures(result.images[pair.base], result.images[pair.match]);
      json["convergence_deg"] = known(figures.convergence);
      json["days"] = known(figures.days);
      json["sun_deg"] = known(figures.sun);
      json["overlap"] = figures.overlap;
    }
    pairs.push_back(std::move(json));
  }
  return pairs;
}

Json cells_json(const SurfaceResult& result) {
  Json json;
  json["count"] = result.sources.total();
  const auto cells = static_cast<double>(result.sources.total());
  const auto filled = std::ranges::count(result.sources, static_cast<int>(HeightSource::filled));
  json["filled"] = static_cast<double>(filled) / cells;
  if (result.reasons.empty()) return json;
  Json shares = Json::object();
  const auto all = cell_shares(result.reasons);
  for (int i = 0; i < kCellReasonCount; ++i) {
    shares[reason_name(i)] = all[static_cast<std::size_t>(i)];
  }
  json["shares"] = shares;
  return json;
}

}  // namespace xgm::geo
