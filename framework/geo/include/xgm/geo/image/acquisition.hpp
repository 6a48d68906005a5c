// SPDX-License-Identifier: Apache-2.0
// When an image was taken, where the sun stood, and how cloudy it was.
#pragma once

#include <optional>
#include <string>

#include "xgm/base/export.hpp"

namespace xgm::geo {

/// What the vendor's metadata say; empty: unknown.
struct Acquisition {
  std::optional<double> time;           ///< s since 1970, UTC
  std::optional<double> sun_azimuth;    ///< degrees, north is 0, east 90
  std::optional<double> sun_elevation;  ///< degrees
  std::optional<double> cloud_cover;    ///< share, 0 to 1
};

/// From a file of metadata: DIMAP (DIM_*.XML), DigitalGlobe (XML with an IMD block, .IMD), or an
/// image that holds them (NITF: its date, USE00A and PIAIMC). Throws Error, which names the file,
/// if it cannot be read.
XGM_API Acquisition read_acquisition(const std::string& file);

/// Of an image: from its camera's file, the image itself and the vendor's files beside it, the
/// first that knows a value. What none knows, or says in a way that is not understood, is unknown.
XGM_API Acquisition find_acquisition(const std::string& image_file,
                                     const std::string& camera_file = {});

}  // namespace xgm::geo
