// SPDX-License-Identifier: Apache-2.0
#include "reduced_pair.hpp"

#include "xgm/data/halve.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm::tiles {
namespace {

void paste(const Image& part, const cv::Rect& place, cv::Size size, Image& whole) {
  if (whole.planes.empty()) {
    for (std::size_t k = 0; k < part.planes.size(); ++k) whole.planes.emplace_back(size);
  }
  for (std::size_t k = 0; k < part.planes.size(); ++k)
    part.planes[k].copyTo(whole.planes[k](place));
  if (part.valid.empty() && whole.valid.empty()) return;
  if (whole.valid.empty()) whole.valid = cv::Mat1b(size, std::uint8_t{255});
  if (part.valid.empty()) {
    whole.valid(place).setTo(255);
  } else {
    part.valid.copyTo(whole.valid(place));
  }
}

}  // namespace

ImagePair reduced_pair(const PairWindows& pair, int scale) {
  const cv::Size size = pair.size();
  const cv::Size small(reduced(size.width, scale), reduced(size.height, scale));
  ImagePair whole;
  for (const cv::Rect& window : row_bands(size, scale)) {  // of whole blocks of pixels
    ImagePair part = pair.read(window);
    for (int s = 1; s < scale; s *= 2) {
      part = {halve(part.base), halve(part.match), part.is_reverse};
    }
    const cv::Rect place = reduced(window, scale);
    paste(part.base, place, small, whole.base);
    paste(part.match, place, small, whole.match);
    whole.is_reverse = part.is_reverse;
  }
  return whole;
}

}  // namespace xgm::tiles
