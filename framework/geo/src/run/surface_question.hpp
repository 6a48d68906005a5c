// SPDX-License-Identifier: Apache-2.0
// What decides of a surface, told before it is made.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/geo/run/recorded_surface.hpp"

namespace xgm::geo {

/// All that does, by names that people know: what decides of any run (question_of()), the content
/// of images, masks, cameras, DEM and the files beside them, the area, the band, the geoid. `read`
/// are the files of `files`, `images` what was read from them. Throws Error.
Json question_of(const Pipeline& pipeline, const SurfaceFiles& files,
                 const std::vector<InputFile>& read, const std::vector<SatelliteImage>& images,
                 const SurfaceRecordRequest& request);

/// The part of it that decides of what is matched, when pixels and bounds are known.
Json question_of_matching(const Json& question);

}  // namespace xgm::geo
