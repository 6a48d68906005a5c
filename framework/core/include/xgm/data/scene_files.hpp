// SPDX-License-Identifier: Apache-2.0
// The files of a scene, and what is known of it before an image is opened.
#pragma once

#include <opencv2/core/types.hpp>
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
  std::string left_mask{};  ///< nonzero where the left image may be used
  std::string right_mask{};
};

/// Disparities in a file: PFM (px, not finite = none), or an 8- or 16-bit image (0 = none). A
/// disparity in px is value / divisor; the divisor is negative for reverse maps that are stored as
/// positive numbers. Divisor 0 means unknown: whole numbers are refused, and floats are divided by
/// 1 (reverse: by -1).
struct DisparityFile {
  std::string file{};  ///< empty if there is none
  double divisor = 1;
};

/// Files of the ground truth of a scene. Each may be missing (empty).
struct TruthFiles {
  DisparityFile disparity{};   ///< of the left view, including hidden pixels if known
  DisparityFile reverse{};     ///< of the right view
  DisparityFile visible{};     ///< of the left view, without the pixels hidden in the right (KITTI)
  std::string non_occluded{};  ///< mask: 255 where a left pixel is visible in the right image
  std::string objects{};       ///< KITTI's object map: 0 = background
};

/// What is wrong with a file of a scene.
struct FileFault {
  std::string file{};
  std::string message{};  ///< one sentence: the file, the place in it, and the remedy
};

/// A scene of a data set.
struct SceneFiles {
  std::string name{};     ///< "Motorcycle", unique in its data set
  std::string dataset{};  ///< plugin that knows its layout; set by find_scenes
  PairFiles images{};
  TruthFiles truth{};
  std::string calibration_file{};  ///< empty if there is none
  std::optional<Calibration> calibration{};
  /// Of the images that calibration_file is about, px; a side that it does not tell is 0.
  cv::Size calibrated_size{};
  std::optional<Interval> disparities{};  ///< to search, if the data set gives them
  std::string disparities_file{};         ///< where they stand; empty: the data set knows them
  double weight = 1;                      ///< of this scene in the benchmark's averages
  /// Size of a pixel in pixels of the benchmark's full resolution (4 in Middlebury's trainingQ).
  double scale = 1;
  /// What other scenes of this kind have but this one lacks: one sentence each, with its purpose
  /// and where to get it.
  std::vector<std::string> missing{};
  /// What is there but of no use. It stops no other scene, and this one only if it is needed.
  std::vector<FileFault> faults{};
};

}  // namespace xgm
