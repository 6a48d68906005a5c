// SPDX-License-Identifier: Apache-2.0
// What two runs have differently: `pipeline diff`, for any program.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/table.hpp"

namespace xgm {

/// A value that two runs do not have alike; kNoFigure where a run has none.
struct Difference {
  std::string what;  ///< "matcher.scale", "left image"
  std::string first, second;
};

/// A square of the image in which many pixels differ.
struct DifferentPlace {
  cv::Rect square{};
  std::int64_t pixels = 0;  ///< of it that differ
  double largest = 0;       ///< difference of two disparities, px
};

/// Two maps of one size, of disparities in px or of confidences. A pixel differs if it is moved, or
/// has a disparity in one map only.
struct MapDifference {
  std::int64_t pixels = 0;       ///< of each map
  std::int64_t moved = 0;        ///< their disparities differ by more than the threshold
  std::int64_t only_first = 0;   ///< have a disparity in the first map only
  std::int64_t only_second = 0;  ///< likewise
  double mean = 0;               ///< difference of the pixels that have two disparities, px
  double largest = 0;
  cv::Rect box{};                       ///< of all pixels that differ; empty if none does
  std::vector<DifferentPlace> worst{};  ///< at most five, those with the most pixels first

  std::int64_t differing() const { return moved + only_first + only_second; }
};

/// Of disparities in px, NaN where there is none. Throws Error if the sizes differ.
XGM_API MapDifference compare_maps(const cv::Mat1f& first, const cv::Mat1f& second,
                                   double threshold);

/// Black where the maps are the same or neither has a disparity, white and grey where only the
/// first or the second has one, else the difference in colours with a legend.
XGM_API cv::Mat3b difference_picture(const cv::Mat1f& first, const cv::Mat1f& second,
                                     double threshold);

struct XGM_API RunDiff {
  std::vector<Difference> files;              ///< what a comparison needs and one run lacks
  std::vector<Difference> configuration;      ///< parameters, and the disparities searched
  std::vector<Difference> program;            ///< versions
  std::vector<Difference> inputs;             ///< by content, whatever the files are called
  std::vector<Difference> map_size;           ///< if the sizes of the maps differ
  std::optional<MapDifference> map{};         ///< if both runs have maps of one size
  std::optional<MapDifference> confidence{};  ///< if both have some, and anything counts
  std::vector<Difference> figures;  ///< time, memory and the like; these count for nothing
  std::vector<std::string> notes;   ///< what neither run has

  bool same() const;
};

/// Compares the output folders of two runs. A disparity is moved if it differs by more than
/// `threshold` px; confidences, whose values are no disparities, are compared if that is 0. Throws
/// Error if a folder holds no run, or a file of it is damaged.
XGM_API RunDiff compare_runs(const std::string& first, const std::string& second, double threshold);

/// The map of a run, to make a picture of; empty if there is none.
XGM_API cv::Mat1f read_map_of_run(const std::string& folder);

/// All of it for people.
XGM_API std::string diff_text(const RunDiff& diff);

}  // namespace xgm
