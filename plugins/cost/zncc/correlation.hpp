// SPDX-License-Identifier: Apache-2.0
// Zero-mean normalised cross-correlation over windows, for one tile of the image at a time.
#pragma once

#include "xgm/data/image.hpp"

namespace xgm::zncc {

/// Correlations of the windows around the pixels of a tile with those in the match image. A window
/// consists of the samples that exist in both views: neither outside nor masked. Time per pixel
/// does not depend on the size of the window (box sums). Keep the pair alive; one thread at a time.
class Correlator {
 public:
  /// `window` is odd, in pixels.
  Correlator(const ImagePair& pair, cv::Rect tile, int window);

  /// Correlation at disparity d of each pixel of the tile, -1 to 1: the mean over the channels. 0
  /// where a window is flat, for a flat window is neither like nor unlike another. Valid until the
  /// next call.
  const cv::Mat1d& at(int d);

 private:
  /// What is summed over a window: 1, b, m, b b, m m, b m.
  using Sample = cv::Vec6d;

  void sample(std::size_t channel, int d);
  static double correlation(const Sample& sums);

  const ImagePair& pair_;
  cv::Rect tile_;
  int window_;
  cv::Rect support_;  // the tile and all its windows; may reach outside the image
  cv::Mat_<Sample> samples_, sums_;
  cv::Mat1d result_;
};

}  // namespace xgm::zncc
