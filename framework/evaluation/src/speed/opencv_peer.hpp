// SPDX-License-Identifier: Apache-2.0
// OpenCV's StereoSGBM as a peer in the race: nothing but its own work is timed.
#pragma once

#include <string>

#include "xgm/data/match.hpp"
#include "xgm/evaluation/speed.hpp"

namespace xgm::speed {

/// Images in the form that OpenCV takes, made before anything is timed.
class OpenCvPeer {
 public:
  OpenCvPeer(const ImagePair& pair, Interval disparities);

  /// Times one run of a mode. Throws Error if this mode is not known, the disparities are none
  /// that OpenCV knows, or it fails.
  RunSeconds run(const std::string& mode) const;

 private:
  cv::Mat1b left_, right_;
  Interval searched_;
};

/// "OpenCV HH"
std::string peer_name(const std::string& mode);

}  // namespace xgm::speed
