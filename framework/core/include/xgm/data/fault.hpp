// SPDX-License-Identifier: Apache-2.0
// What is wrong with data that a stage has made: the rules of their types, for runs and for tests.
#pragma once

#include <optional>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// A rule that is broken, told as what is wrong ("the reverse map is gone").
struct Fault {
  std::string rule;
  std::optional<cv::Point> pixel{};  ///< the first one that breaks it, if it is one of pixels
};

/// "the status is none there is (x 3, y 5)"
XGM_API std::string to_string(const Fault& fault);

/// None if both images have pixels, one or three planes, finite where there are data, and all
/// planes and masks are of the size.
XGM_API std::optional<Fault> fault_of(const ImagePair& pair, cv::Size size);

/// None if the confidence is of the size, and each is in 0 to 1 or NaN.
XGM_API std::optional<Fault> fault_of_confidence(const cv::Mat1f& confidence, cv::Size size);

/// What may be in a map beside its invariant.
struct MapBounds {
  cv::Size size;
  /// If known: a matched disparity lies less than a pixel outside of it (refinement moves it by
  /// half a pixel), and one that is filled is smaller than the image is wide.
  std::optional<Interval> searched{};
};

/// None if the map is of the size, its statuses are those there are, exactly the pixels whose
/// status says so have a finite disparity, which lies within the bounds, and the confidence, if
/// there is one, is sound.
XGM_API std::optional<Fault> fault_of(const DisparityMap& map, const MapBounds& bounds);

}  // namespace xgm
