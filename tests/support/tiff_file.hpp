// SPDX-License-Identifier: Apache-2.0
// Writes TIFFs as other programs do: with bands apart, in tiles, with GDAL's tag.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace xgm::testing {

struct TiffStyle {
  std::string no_data{};  ///< text of GDAL_NODATA, "" for no tag
  bool bands_apart = false;
  bool tiled = false;
  bool compressed = false;
  bool big = false;        ///< BigTIFF
  bool has_alpha = false;  ///< the last band is alpha
  bool white_is_zero = false;
  int orientation = 1;
};

/// Writes bands of one size and type, the first of which is grey or red.
void write_tiff(const std::string& file, const std::vector<cv::Mat>& bands,
                const TiffStyle& style = {});

}  // namespace xgm::testing
