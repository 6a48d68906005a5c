// SPDX-License-Identifier: Apache-2.0
// Which pixels are to be explained.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "xgm/evaluation/explain.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::cli {

/// Decided before any image is opened.
struct ExplainPixels {
  std::vector<cv::Point> pixels;
  int every = 0;  ///< distance of the pixels of a grid; 0: none

  bool empty() const { return pixels.empty() && every == 0; }
};

/// "X,Y" or "every=N", any number of them. Throws UsageError.
ExplainPixels parse_explain(const std::vector<std::string>& texts);

/// "X" and "Y" of the command line. Throws UsageError.
cv::Point parse_pixel(const std::string& x, const std::string& y);

/// Watches the pixels in a run of this scene. Throws UsageError if one lies outside.
std::unique_ptr<Explainer> make_explainer(const ExplainPixels& wanted, const Scene& scene);

}  // namespace xgm::cli
