// SPDX-License-Identifier: Apache-2.0
// A disparity map: a disparity and a status per pixel.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm {

/// Why a pixel has its disparity, or why it has none.
enum class Status : std::uint8_t {
  matched,       ///< has the disparity that the matcher found
  filled,        ///< has a disparity that was interpolated, not matched
  masked,        ///< no image data at this pixel
  out_of_range,  ///< no disparity in the search range can be matched here
  ambiguous,     ///< the best disparity is not clearly better than the others
  occluded,      ///< failed the consistency check; hidden in the other view
  mismatched,    ///< failed the consistency check, although visible in the other view
  peak,          ///< belonged to a segment too small to be trusted
};
inline constexpr int kStatusCount = 8;

/// The name in files and pictures: "valid" (matched), "filled", ...
XGM_API std::string_view to_string(Status status);

/// Whether pixels of this status have a disparity.
constexpr bool has_disparity(Status status) {
  return status == Status::matched || status == Status::filled;
}

/// Disparities in pixels, NaN where a pixel has none, and a status per pixel that says why.
/// Invariant: a disparity is finite if and only if has_disparity(status).
class XGM_API DisparityMap {
 public:
  DisparityMap() = default;
  /// All pixels NaN, with this status.
  explicit DisparityMap(cv::Size size, Status status = Status::out_of_range);

  cv::Size size() const { return disparity.size(); }
  bool has_disparity(int y, int x) const { return xgm::has_disparity(at(y, x)); }
  /// The same, by the name that plugins written for earlier versions use.
  bool valid(int y, int x) const { return has_disparity(y, x); }
  Status at(int y, int x) const { return static_cast<Status>(status(y, x)); }
  void set(int y, int x, float value, Status why = Status::matched) {
    disparity(y, x) = value;
    status(y, x) = static_cast<std::uint8_t>(why);
  }
  /// Removes the disparity; `why` is the reason.
  void invalidate(int y, int x, Status why);
  /// Share of pixels that have a disparity, 0 to 1 (0 for an empty map).
  double density() const;
  /// A copy that shares no pixels with this map.
  DisparityMap clone() const;
  std::size_t bytes() const {
    return disparity.total() * (sizeof(float) + 1) + confidence.total() * sizeof(float);
  }
  /// Takes the confidence of the map that this one was made of, if it has none of its own. It is
  /// one of matched disparities: pixels that are not matched any more, or are filled, lose it.
  void inherit_confidence(const DisparityMap& origin);

  cv::Mat1f disparity;   ///< pixels; x_match = x_base - disparity
  cv::Mat1b status;      ///< one Status per pixel
  cv::Mat1f confidence;  ///< 0 to 1 per pixel, not finite = none; empty if no stage made it
};

}  // namespace xgm
