// SPDX-License-Identifier: Apache-2.0
// What the figures of the tables mean.
#include <algorithm>

#include "bench/table.hpp"
#include "xgm/base/text.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

std::string scale_text(double scale) {
  if (scale == 0) return "Errors are in pixels of each benchmark's full resolution.";
  if (scale == 1) return "Errors are in pixels of the maps.";
  return "Errors are in pixels of the maps times " + short_number(scale) + ".";
}

std::string region_text(const std::string& region) {
  if (region.empty()) return "Judged are non-occluded pixels that have a true disparity.";
  return "Judged are the pixels of the region \"" + region + "\" that have a true disparity.";
}

}  // namespace

std::vector<std::string> explanations(const BenchResult& result) {
  std::vector<std::string> texts{
      region_text(result.rules.region),
      scale_text(result.rules.scale),
      "avg err: mean error of the pixels that have a disparity, px. invalid: pixels without one, "
      "bad: off by more than so many px, total: invalid + bad; all in percent.",
      "s: seconds of matching (" + std::to_string(result.request.threads) +
          (result.request.threads == 1 ? " thread" : " threads") +
          "), MB: the most memory the run's process had, MDE/s: million disparity evaluations per "
          "second, width x height x disparities of the search range / seconds.",
      "Averages: errors by the data set's weights; seconds are a mean, MB the largest.",
      "Made with xgm " XGM_VERSION "."};
  if (result.rules.clip) texts.insert(texts.begin() + 2, "Disparities are clipped to 0 to ndisp.");
  return texts;
}

}  // namespace xgm
