// SPDX-License-Identifier: Apache-2.0
// What is known of a scene before any of its images is opened.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/data/calibration.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// Files of a pair. Masks may be left empty.
struct PairFiles {
  std::string left{};
  std::string right{};
  std::string left_mask{};  ///< non-zero where the left image may be used
  std::string right_mask{};
};

/// Disparities on disk: PFM (px, not finite = none), or an image of 8 or 16 bit (0 = none). In px:
/// value / divisor, negative for reverse maps that are stored as positive numbers. Divisor 0 = not
/// said: whole numbers are refused, floats divided by 1 (reverse: by -1).
struct DisparityFile {
  std::string file{};  ///< empty: there is none
  double divisor = 1;
};

/// Truth of a scene; files may be empty.
struct TruthFiles {
  DisparityFile disparity{};   ///< of the left view, hidden pixels included where they are known
  DisparityFile reverse{};     ///< of the right view
  DisparityFile visible{};     ///< of the left view, without the pixels hidden in the right (KITTI)
  std::string non_occluded{};  ///< mask: 255 where a left pixel is seen in the right image, too
  std::string objects{};       ///< KITTI's object map: 0 = background
};

/// A scene of a data set.
struct SceneFiles {
  std::string name{};     ///< "Motorcycle", unique in its data set
  std::string dataset{};  ///< plugin that knows its layout; filled in by find_scenes
  PairFiles images{};
  TruthFiles truth{};
  std::string calibration_file{};  ///< empty if there is none
  std::optional<Calibration> calibration{};
  std::optional<Interval> disparities{};  ///< to be searched, if the data set says so
  double weight = 1;                      ///< of this scene in the benchmark's averages
  /// One pixel here is so many of the benchmark's full resolution (4 in Middlebury's trainingQ).
  double scale = 1;
  /// What such scenes have and this one lacks, a sentence each: what it is for, where to get it.
  std::vector<std::string> missing{};
};

}  // namespace xgm
