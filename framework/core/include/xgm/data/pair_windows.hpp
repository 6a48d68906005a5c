// SPDX-License-Identifier: Apache-2.0
// A pair of images that is read in parts.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

class XGM_API PairWindows {
 public:
  virtual ~PairWindows();
  virtual cv::Size size() const = 0;
  /// `window`, the same in both images, lies within them. Any thread may call it.
  virtual ImagePair read(const cv::Rect& window) const = 0;
};

class XGM_API PairInMemory final : public PairWindows {
 public:
  explicit PairInMemory(ImagePair pair) : pair_(std::move(pair)) {}
  cv::Size size() const override { return pair_.size(); }
  ImagePair read(const cv::Rect& window) const override;

 private:
  ImagePair pair_;
};

/// Whether both images have the same values in all planes, bit for bit.
XGM_API bool have_same_pixels(const PairWindows& pair);

}  // namespace xgm
