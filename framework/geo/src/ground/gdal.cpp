// SPDX-License-Identifier: Apache-2.0
#include "ground/gdal.hpp"
#include "ground/paths.hpp"

#include <cpl_error.h>

#include <mutex>

#include "xgm/base/error.hpp"

namespace xgm::geo {

QuietGdal::QuietGdal() {
  CPLErrorReset();
  CPLPushErrorHandler(CPLQuietErrorHandler);  // of this thread
}

QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

std::string QuietGdal::message() { return CPLGetLastErrorMsg(); }

DatasetPtr open_raster(const std::string& file) {
  static std::once_flag registered;
  std::call_once(registered, [] { GDALAllRegister(); });
  const QuietGdal quiet;
  if (!is_there(file)) throw Error(file + ": there is no such file");
  DatasetPtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (dataset == nullptr && is_folder(file)) {
    throw Error(file + ": is a folder; name a file in it");
  }
  if (dataset == nullptr) {
    const std::string reason = QuietGdal::message();
    throw Error(file + ": is no raster that GDAL can read: " +
                (reason.empty() ? "its format is not known" : reason));
  }
  return dataset;
}

}  // namespace xgm::geo
