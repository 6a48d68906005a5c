// SPDX-License-Identifier: Apache-2.0
// Which pixels of a scene are to be explained.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/explain.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {

/// Chosen before the size of the images is known.
struct ExplainPixels {
  std::vector<cv::Point> pixels{};
  int every = 0;  ///< step of a pixel_grid() besides; 0: none

  bool empty() const { return pixels.empty() && every == 0; }
};

/// Watches the pixels in a run of this scene. Throws UsageError if one lies outside.
XGM_API std::unique_ptr<Explainer> make_explainer(const ExplainPixels& wanted, const Scene& scene);

}  // namespace xgm
