// SPDX-License-Identifier: Apache-2.0
// An image file as it is stored, before its values are scaled.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {

/// What decoders give, in the type of the file.
struct StoredImage {
  std::vector<cv::Mat> channels{};  ///< one (grey) or three (blue, green, red)
  cv::Mat alpha{};                  ///< empty if there is none
  std::optional<double> no_data{};  ///< the value that means no data, if the file names one
};

/// Of pixels whose bands lie together; the last of two or four is alpha.
StoredImage split_bands(const cv::Mat& pixels);

/// Decodes any format. Throws Error.
StoredImage read_stored(const std::string& file);

/// What it holds as values, for a file or a window of it. `alpha` says whether alpha tells where
/// there is data: not if it is 0 in all of the file.
UnscaledImage to_unscaled(StoredImage stored, const std::string& file, bool alpha,
                          const std::vector<double>& no_data);

/// Decodes any format. A pixel has no data where alpha is 0, where a value is not finite, or where
/// all bands equal the value that the file names (GDAL_NODATA) or one of `no_data`; values are
/// compared in the type of the file. Throws Error. Exported for the tests only.
XGM_API UnscaledImage read_unscaled(const std::string& file,
                                    const std::vector<double>& no_data = {});

/// "8-bit", "16-bit", "float", ...
std::string depth_name(int depth);

/// "640 x 480"
std::string size_text(cv::Size size);

}  // namespace xgm
