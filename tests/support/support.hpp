// SPDX-License-Identifier: Apache-2.0
// What many tests need: stages from YAML, random inputs, thread counts, real data.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin.hpp"
#include "xgm/testing/random.hpp"

namespace xgm::testing {

/// The library's own plugins.
const Registry& builtins();

/// A stage from YAML: stage<Cost>("{type: census, window: 5}"). Throws Error if it is faulty.
template <class Kind>
std::shared_ptr<const Kind> stage(const std::string& yaml) {
  return make_stage<Kind>(yaml, builtins());
}

/// Noise in whole grey levels 0..255; `channels` planes.
Image random_image(cv::Size size, std::uint64_t seed, int channels = 1);
/// Noise whose match image is the base image shifted by `disparity`, new noise at the border.
ImagePair shifted_pair(cv::Size size, int disparity, std::uint64_t seed, int channels = 1);
/// About `share` of the pixels are 0, the others 255.
cv::Mat1b random_mask(cv::Size size, double share, std::uint64_t seed);
/// Random intervals within `hull`, about a tenth of them empty.
DisparityRange random_range(cv::Size size, Interval hull, std::uint64_t seed);

/// Bitwise equality of two maps, NaN equal to NaN.
bool identical(const DisparityMap& a, const DisparityMap& b);
/// Bitwise equality of cells.
/// All cells of a volume, pixel by pixel.
template <class Cell>
std::vector<Cell> all_cells(const Volume<Cell>& volume) {
  std::vector<Cell> all;
  for (int y = 0; y < volume.shape().height(); ++y) {
    for (int x = 0; x < volume.shape().width(); ++x) {
      const auto slice = volume.cells(y, x);
      all.insert(all.end(), slice.begin(), slice.end());
    }
  }
  return all;
}

bool identical(const CostVolume& a, const CostVolume& b);
bool identical(const AggregatedVolume& a, const AggregatedVolume& b);

/// The folder of real data (environment variable XGM_TEST_DATA). Without it prints "SKIPPED:
/// <what>", marks the run as skipped and returns nothing; the test case then returns.
std::optional<std::filesystem::path> test_data(const std::string& what);
bool was_skipped();

}  // namespace xgm::testing
