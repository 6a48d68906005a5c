// SPDX-License-Identifier: Apache-2.0
// GDAL, opened once and with its messages turned into errors of ours.
#pragma once

#include <gdal_priv.h>

#include <memory>
#include <string>
#include <vector>

namespace xgm::geo {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, CloseDataset>;

/// Keeps GDAL's messages from stderr while it lives, and the last of them for errors.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
  /// What GDAL has said last; empty if nothing.
  static std::string message();
};

/// For reading. Throws Error, which names the file.
DatasetPtr open_raster(const std::string& file);

}  // namespace xgm::geo
