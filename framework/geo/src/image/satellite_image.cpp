// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/satellite_image.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "ground/gdal.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/camera/read_rpc.hpp"

namespace xgm::geo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Where the first pixel lies in the vendor's image, for crops that say it: by an origin without a
/// CRS, in whole pixels.
cv::Point2d origin_of_crop(GDALDataset& dataset, const std::string& file) {
  const char* const crs = dataset.GetProjectionRef();
  double t[6];
  if ((crs != nullptr && *crs != '\0') || dataset.GetGeoTransform(t) != CE_None) return {0, 0};
  const bool whole = t[1] == 1 && t[5] == 1 && t[2] == 0 && t[4] == 0;
  if (whole) return {t[0], t[3]};
  throw Error(file +
              ": its origin says that it is a crop, but its pixels are not those of the "
              "camera (" +
              std::to_string(t[1]) + " x " + std::to_string(t[5]) +
              "); use the image as the vendor delivers it");
}

/// One band of a window, NaN where it has no data.
cv::Mat1f read_band(GDALRasterBand& band, const cv::Rect& window, const std::string& file) {
  cv::Mat1f values(window.size());
  if (band.RasterIO(GF_Read, window.x, window.y, window.width, window.height, values.data,
                    window.width, window.height, GDT_Float32, 0, 0) != CE_None) {
    throw Error(file + ": cannot be read: " + QuietGdal::message());
  }
  int has_nodata = 0;
  const auto nodata = static_cast<float>(band.GetNoDataValue(&has_nodata));
  for (float& value : values) {
    if (!std::isfinite(value) || (has_nodata != 0 && value == nodata)) value = kNone;
  }
  return values;
}

cv::Mat1f read_grey(GDALDataset& dataset, int band, const cv::Rect& window,
                    const std::string& file) {
  if (band > 0) return read_band(*dataset.GetRasterBand(band), window, file);
  cv::Mat1f sum = read_band(*dataset.GetRasterBand(1), window, file);
  for (int i = 2; i <= dataset.GetRasterCount(); ++i) {
    sum += read_band(*dataset.GetRasterBand(i), window, file);
  }
  sum /= dataset.GetRasterCount();
  return sum;
}

cv::Size size_of(GDALDataset& dataset) {
  return {dataset.GetRasterXSize(), dataset.GetRasterYSize()};
}

void apply_mask(const SatelliteImage& image, cv::Size of_image, const cv::Rect& window,
                cv::Mat1f& grey) {
  if (image.mask.empty()) return;
  const DatasetPtr mask = open_raster(image.mask);
  if (size_of(*mask) != of_image) {
    throw Error(image.mask + ": the mask is not of the size of " + image.file);
  }
  const cv::Mat1f used = read_band(*mask->GetRasterBand(1), window, image.mask);
  grey.setTo(kNone, used == 0);
}

/// Of pixels of the file, NaN where it may not be used.
cv::Mat1f read_of_file(GDALDataset& dataset, const SatelliteImage& image, const cv::Rect& window) {
  cv::Mat1f grey = read_grey(dataset, image.band, window, image.file);
  apply_mask(image, size_of(dataset), window, grey);
  return grey;
}

/// The mean of a block; NaN if more than half of it is.
float mean_of(const cv::Mat1f& block) {
  double sum = 0;
  std::size_t count = 0;
  for (const float grey : block) {
    if (std::isnan(grey)) continue;
    sum += double{grey};
    ++count;
  }
  return 2 * count < block.total() ? kNone : static_cast<float>(sum / static_cast<double>(count));
}

/// Some rows at a time: a window of a reduced image is a large one of the file.
cv::Mat1f read_reduced(GDALDataset& dataset, const SatelliteImage& image, const cv::Rect& window) {
  constexpr int kRows = 32;
  const int by = image.reduction;
  cv::Mat1f grey(window.size());
  for (int y = 0; y < window.height; y += kRows) {
    const int rows = std::min(kRows, window.height - y);
    const cv::Mat1f part = read_of_file(
        dataset, image, {window.x * by, (window.y + y) * by, window.width * by, rows * by});
    for (int row = 0; row < rows; ++row) {
      for (int x = 0; x < window.width; ++x) {
        grey(y + row, x) = mean_of(part(cv::Rect(x * by, row * by, by, by)));
      }
    }
  }
  return grey;
}

}  // namespace

SatelliteImage reduced(const SatelliteImage& image, int by) {
  SatelliteImage small = image;
  small.size = {image.size.width / by, image.size.height / by};
  small.reduction = image.reduction * by;
  small.camera = image.camera.reduced(by);
  return small;
}

SatelliteImage open_image(const std::string& file, const std::string& camera_file) {
  const DatasetPtr dataset = open_raster(file);
  const std::vector<RpcModel> models =
      camera_file.empty() ? read_rpc_of_image(file) : read_rpc(camera_file);
  if (models.empty()) {
    throw Error(file +
                ": holds no RPC camera; put the vendor's file (_RPC.TXT, .RPB, RPC_*.XML) "
                "beside it, or name one for each image with --cameras");
  }
  // What the image itself holds is of its own pixels; a file of its own is of the vendor's image.
  const cv::Point2d origin =
      camera_file.empty() ? cv::Point2d(0, 0) : origin_of_crop(*dataset, file);
  return {.name = std::filesystem::path(file).stem().string(),
          .file = file,
          .band = dataset->GetRasterCount() == 1 ? 1 : 0,
          .mask = {},
          .size = size_of(*dataset),
          .bands = dataset->GetRasterCount(),
          .camera = RpcCamera(models.front()).cropped(origin),
          .acquisition = find_acquisition(file, camera_file)};
}

cv::Mat1f read_window(const SatelliteImage& image, cv::Rect window) {
  const QuietGdal quiet;
  cv::Mat1f grey(window.size(), kNone);
  const cv::Rect inside = window & cv::Rect({}, image.size);
  if (inside.empty()) return grey;
  const DatasetPtr dataset = open_raster(image.file);
  const cv::Mat1f part = image.reduction > 1 ? read_reduced(*dataset, image, inside)
                                             : read_of_file(*dataset, image, inside);
  part.copyTo(grey(inside - window.tl()));
  return grey;
}

}  // namespace xgm::geo
