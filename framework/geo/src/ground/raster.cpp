// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/raster.hpp"

#include <gdal_priv.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "ground/gdal.hpp"
#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm::geo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// In place; compared as doubles, since a tag may say more digits than a float has.
void remove_nodata(cv::Mat1f& values, GDALRasterBand& band) {
  int has_nodata = 0;
  const auto nodata = static_cast<float>(band.GetNoDataValue(&has_nodata));
  for (float& value : values) {
    if (!std::isfinite(value) || (has_nodata != 0 && value == nodata)) value = kNone;
  }
}

void require(bool done, const std::string& file, const std::string& what) {
  if (!done) throw Error(file + ": " + what + ": " + QuietGdal::message());
}

GridPlace place_of(GDALDataset& dataset, const std::string& file) {
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None) return {0, 0, 1, 1};
  if (t[2] != 0 || t[4] != 0) {
    throw Error(file + ": the raster is rotated; warp it north up first (gdalwarp)");
  }
  return {t[0], t[3], t[1], t[5]};
}

RasterHead head_of(GDALDataset& dataset, const std::string& file) {
  const char* const crs = dataset.GetProjectionRef();
  RasterHead head{.size = {dataset.GetRasterXSize(), dataset.GetRasterYSize()},
                  .bands = dataset.GetRasterCount(),
                  .place = place_of(dataset, file),
                  .crs = crs != nullptr ? crs : "",
                  .metadata = {}};
  for (char** entry = dataset.GetMetadata(); entry != nullptr && *entry != nullptr; ++entry) {
    const std::string text(*entry);
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos)
      head.metadata[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return head;
}

/// The bytes of the file, made in memory: it gets its name when it is complete.
std::string encode(GDALDriver& cog, GDALDataset& dataset, bool labels, const std::string& file) {
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=YES",
                                 labels ? "RESAMPLING=NEAREST" : "RESAMPLING=AVERAGE", nullptr};
  const std::string name =
      "/vsimem/xgm/" + std::to_string(reinterpret_cast<std::uintptr_t>(&dataset));
  const DatasetPtr copy(
      cog.CreateCopy(name.c_str(), &dataset, FALSE, const_cast<char**>(options), nullptr, nullptr));
  require(copy != nullptr, file, "cannot be written");
  copy->FlushCache();
  vsi_l_offset size = 0;
  const GByte* const bytes = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
  std::string encoded(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIUnlink(name.c_str());
  VSIUnlink((name + ".aux.xml").c_str());
  return encoded;
}

/// `values` are floats, or codes of 8 bit. Replaces the file, and what GDAL and others have kept
/// beside it: that belongs to what it held.
void write_cog(const std::string& file, const cv::Mat& values, const GridPlace& place,
               const Crs& grid_crs, const std::map<std::string, std::string>& metadata) {
  GDALAllRegister();
  const QuietGdal quiet;
  GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDriver* const cog = GetGDALDriverManager()->GetDriverByName("COG");
  require(memory != nullptr && cog != nullptr, file,
          "this GDAL cannot write cloud-optimised GeoTIFF");
  const bool labels = values.depth() == CV_8U;
  const GDALDataType type = labels ? GDT_Byte : GDT_Float32;
  const DatasetPtr dataset(memory->Create("", values.cols, values.rows, 1, type, nullptr));
  require(dataset != nullptr, file, "not enough memory");
  double t[6] = {place.left, place.step_x, 0, place.top, 0, place.step_y};
  if (!grid_crs.empty()) {
    dataset->SetGeoTransform(t);
    const bool is_ellipsoidal = has_ellipsoidal_heights(grid_crs);
    const Crs crs = is_ellipsoidal ? horizontal(grid_crs) : grid_crs;
    require(dataset->SetProjection(crs.c_str()) == CE_None, file, "has an unknown CRS");
    if (is_ellipsoidal) {
      dataset->SetMetadataItem("vertical_datum", std::string(kEllipsoidalHeights).c_str());
    }
  }
  for (const auto& [name, value] : metadata) {
    dataset->SetMetadataItem(name.c_str(), value.c_str());
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (!labels) band.SetNoDataValue(kNone);
  const cv::Mat whole = values.isContinuous() ? values : values.clone();
  require(band.RasterIO(GF_Write, 0, 0, whole.cols, whole.rows, whole.data, whole.cols, whole.rows,
                        type, 0, 0) == CE_None,
          file, "cannot be written");
  for (const char* beside : {".aux.xml", ".ovr", ".msk"}) remove_file(file + beside);
  write_file(file, encode(*cog, *dataset, labels, file));
}

}  // namespace

RasterHead read_raster_head(const std::string& file) {
  const DatasetPtr dataset = open_raster(file);
  const QuietGdal quiet;
  return head_of(*dataset, file);
}

std::vector<std::string> files_of_raster(const std::string& file) {
  const DatasetPtr dataset = open_raster(file);
  const QuietGdal quiet;
  std::vector<std::string> files;
  char** const list = dataset->GetFileList();
  for (char** name = list; name != nullptr && *name != nullptr; ++name) {
    const bool is_local = is_there(*name);  // what lies in archives or the net is not known here
    if (is_local && !std::string_view(*name).ends_with(".aux.xml")) files.emplace_back(*name);
  }
  CSLDestroy(list);
  return files;
}

Raster read_raster_window(const std::string& file, const cv::Rect& window, int band_number) {
  const DatasetPtr dataset = open_raster(file);
  const QuietGdal quiet;
  RasterHead head = head_of(*dataset, file);
  if (band_number < 1 || band_number > head.bands) {
    throw Error(file + ": has " + std::to_string(head.bands) + " bands, no band " +
                std::to_string(band_number));
  }
  GDALRasterBand& band = *dataset->GetRasterBand(band_number);
  Raster raster{cv::Mat1f(window.size()), head.place, head.crs, std::move(head.metadata)};
  require(
      band.RasterIO(GF_Read, window.x, window.y, window.width, window.height, raster.values.data,
                    window.width, window.height, GDT_Float32, 0, 0) == CE_None,
      file, "cannot be read to its end");
  remove_nodata(raster.values, band);
  raster.place.left += window.x * raster.place.step_x;
  raster.place.top += window.y * raster.place.step_y;
  return raster;
}

Raster read_raster(const std::string& file, int band_number) {
  return read_raster_window(file, cv::Rect({}, read_raster_head(file).size), band_number);
}

void write_raster(const std::string& file, const Raster& raster) {
  write_cog(file, raster.values, raster.place, raster.crs, raster.metadata);
}

void write_labels(const std::string& file, const LabelRaster& labels) {
  write_cog(file, labels.values, labels.place, labels.crs, labels.metadata);
}

}  // namespace xgm::geo
