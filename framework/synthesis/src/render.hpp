// SPDX-License-Identifier: Apache-2.0
// Looks at surfaces along the rays of both views.
#pragma once

#include "surface.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {

/// The ray of a point of the base (false) or of the match image, which `shift` has moved.
Ray ray_of(bool match, const VerticalShift& shift, double x, double y);

/// Fills the truths and masks, which are exact at pixel centres.
void render_truth(const Surfaces& surfaces, const Options& options, GeneratedScene& scene);

/// The light that arrives at each pixel through the lens; grey levels, neither clipped nor rounded.
Image render_view(const Surfaces& surfaces, const Options& options, bool match);

}  // namespace xgm::synthesis
