// SPDX-License-Identifier: Apache-2.0
// TIFF by libtiff. OpenCV does not tell the tag GDAL_NODATA, and mixes bands up that lie apart.
#pragma once

#include <string>
#include <string_view>

#include "io/unscaled_image.hpp"

namespace xgm {

/// Whether a file that begins with these bytes is a TIFF or a BigTIFF.
bool is_tiff(std::string_view head);

/// The first image of a TIFF, and the value of GDAL_NODATA, which is one for all bands. No channels
/// are given of images that OpenCV has to decode: those that are to be turned by 90 degrees, and
/// samples that are not plain numbers of whole bytes (palettes, single bits, colours of JPEG, white
/// as 0). Throws Error; also if GDAL_NODATA is no number, or speaks of samples that are not the
/// values of pixels.
StoredImage read_tiff(const std::string& file);

}  // namespace xgm
