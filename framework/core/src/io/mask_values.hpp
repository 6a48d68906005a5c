// SPDX-License-Identifier: Apache-2.0
// The values of a mask, which may be read in parts.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/unscaled_image.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {

class MaskValues {
 public:
  static constexpr int kCount = 256;
  using Held = std::array<bool, kCount>;

  /// The part as a mask: its largest band, 255 for nonzero values of depths other than 8 bit, 0
  /// without data.
  cv::Mat1b add(const UnscaledImage& part);

  /// Whether the parts so far hold nothing else, and ones.
  bool are_zeros_and_ones() const;
  /// What is doubtful in the parts so far.
  std::vector<std::string> warnings(const std::string& file, MaskUse use) const;

 private:
  Held held_{};
  bool lost_ = false;  ///< whether a pixel without data had a value
};

}  // namespace xgm
