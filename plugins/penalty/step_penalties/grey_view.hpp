// SPDX-License-Identifier: Apache-2.0
// Grey levels along a path: the intensity differences that penalties depend on.
#pragma once

#include <span>

#include "xgm/data/image.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::penalty {

/// One view as a grey image.
class GreyView {
 public:
  explicit GreyView(const Image& image);

  /// |I(p) - I(p - r)| in grey levels for the pixels p of row y. 0 where one of the two is masked
  /// or outside the image: nothing is known of a step there. `out` has the image's width.
  void differences(Direction r, int y, std::span<float> out) const;

 private:
  cv::Mat1f grey_;  // NaN where masked
};

}  // namespace xgm::penalty
