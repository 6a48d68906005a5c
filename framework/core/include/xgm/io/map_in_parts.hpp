// SPDX-License-Identifier: Apache-2.0
// The files of write_maps(), of a map that is never held as a whole.
#pragma once

#include <memory>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/map_summary.hpp"
#include "xgm/io/sampling.hpp"

namespace xgm {

class XGM_API MapInParts {
 public:
  /// `searched`: see MapSummary. Pictures have `picture_pixels` pixels at most, and no more than
  /// write_maps() gives them. Room for disparity.pfm is reserved in the folder, which is there; no
  /// file is seen before it is complete. Throws Error.
  MapInParts(const std::string& folder, cv::Size size, Interval searched, double picture_pixels);
  ~MapInParts();
  MapInParts(const MapInParts&) = delete;
  MapInParts& operator=(const MapInParts&) = delete;

  /// Each pixel is given once. All parts have a confidence, or none has. Throws Error.
  void take(const cv::Rect& place, const DisparityMap& part);

  const MapSummary& summary() const { return summary_; }
  bool has_confidence() const { return confidence_ != nullptr; }

  /// Writes what is not yet written, and gives the files their names, disparity.pfm first. Throws
  /// Error.
  void finish();

  /// Bytes that are held until then, and that finish() takes beside them.
  static double held_bytes(cv::Size size, double picture_pixels);
  static double finish_bytes(cv::Size size, double picture_pixels);
  /// The pictures' pixels for which both take so many bytes.
  static double picture_pixels(double bytes);

 private:
  struct Pfm;
  std::string folder_;
  cv::Size size_;
  std::unique_ptr<Pfm> pfm_, confidence_;
  MapSummary summary_;
  Sampling sampling_;
  DisparityMap shown_;
};

}  // namespace xgm
