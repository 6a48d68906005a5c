// SPDX-License-Identifier: Apache-2.0
// Maps of scenes in files that were made before the run.
#pragma once

#include <optional>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/image.hpp"
#include "xgm/stage/context.hpp"

namespace xgm::exchange {

/// The file that a pattern names: {scene}, {view} (left or right) and {scale} of the level are put
/// in. Throws Error if the scene has no name, or both views, or levels, would have one file.
XGM_API std::string stored_file(const std::string& pattern, const ImagePair& pair,
                                const Context& context);

/// Numbers of a file, not finite = NaN: see read_disparities(). Throws Error, also if the map is of
/// another size than the images.
XGM_API cv::Mat1f read_stored(const std::string& file, std::optional<double> divisor,
                              cv::Size size);

}  // namespace xgm::exchange
