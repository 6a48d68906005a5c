// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/crop.hpp"

namespace xgm {

Image crop(const Image& image, const cv::Rect& window) {
  Image part;
  for (const cv::Mat1f& plane : image.planes) part.planes.push_back(plane(window).clone());
  if (!image.valid.empty()) part.valid = image.valid(window).clone();
  return part;
}

ImagePair crop(const ImagePair& pair, const cv::Rect& window) {
  return {crop(pair.base, window), crop(pair.match, window), pair.is_reverse};
}

DisparityMap crop(const DisparityMap& map, const cv::Rect& window) {
  DisparityMap part;
  part.disparity = map.disparity(window).clone();
  part.status = map.status(window).clone();
  if (!map.confidence.empty()) part.confidence = map.confidence(window).clone();
  return part;
}

MatchResult crop(const MatchResult& maps, const cv::Rect& window) {
  MatchResult part{crop(maps.forward, window), std::nullopt};
  if (maps.reverse) part.reverse = crop(*maps.reverse, window);
  return part;
}

}  // namespace xgm
