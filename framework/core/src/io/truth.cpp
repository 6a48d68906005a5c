// SPDX-License-Identifier: Apache-2.0
// What is true of a scene, read from its files.
#include <cmath>

#include "io/unscaled_image.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

constexpr std::uint8_t kSeen = 255, kHidden = 128;

template <class Map>
Map of_size(Map map, const std::string& file, cv::Size size) {
  if (map.size() == size) return map;
  throw Error(file + ": is " + size_text(map.size()) + " pixels but the images are " +
              size_text(size) + "; truth and masks have the size of the images");
}

cv::Mat1f read_truth(const DisparityFile& from, cv::Size size, std::vector<std::string>& warnings,
                     bool reverse = false) {
  if (from.file.empty()) return {};
  const bool said = from.divisor != 0;
  const auto divisor = said ? std::optional(from.divisor) : std::nullopt;
  const cv::Mat1f map =
      of_size(take(read_disparities(from.file, divisor, from.no_data), warnings), from.file, size);
  return reverse && !said ? cv::Mat1f(-map) : map;
}

cv::Mat1b read_mask_of(const std::string& file, MaskUse use, cv::Size size,
                       std::vector<std::string>& warnings) {
  if (file.empty()) return {};
  return of_size(take(read_mask(file, use), warnings), file, size);
}

/// Pixels whose disparity is also in the map of those that are not hidden.
cv::Mat1b mask_of_visible(const cv::Mat1f& disparity, const cv::Mat1f& visible) {
  cv::Mat1b mask(disparity.size(), 0);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (!std::isfinite(disparity(y, x))) continue;
      mask(y, x) = std::isfinite(visible(y, x)) ? kSeen : kHidden;
    }
  }
  return mask;
}

}  // namespace

cv::Mat1b cross_check(const cv::Mat1f& disparity, const cv::Mat1f& reverse) {
  constexpr float kAgree = 1;  // px
  if (reverse.size() != disparity.size()) {
    throw Error("the truth of the right view is " + size_text(reverse.size()) +
                " pixels, that of the left " + size_text(disparity.size()) +
                "; both have the size of the images");
  }
  cv::Mat1b mask(disparity.size(), 0);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const float d = disparity(y, x);
      if (!std::isfinite(d)) continue;
      const float column = std::nearbyint(static_cast<float>(x) - d);  // halves: to even
      const bool inside = column >= 0 && column < static_cast<float>(reverse.cols);
      const bool agrees =
          inside && std::abs(reverse(y, static_cast<int>(column)) + d) <= kAgree;  // NaN: false
      mask(y, x) = agrees ? kSeen : kHidden;
    }
  }
  return mask;
}

void require_judgeable(const GroundTruth& truth) {
  for (int y = 0; y < truth.disparity.rows; ++y) {
    for (int x = 0; x < truth.disparity.cols; ++x) {
      if (is_judged(truth.disparity, truth.non_occluded, y, x)) return;
    }
  }
  throw Error("the truth has no pixel to judge by; check file and mask");
}

GroundTruth load_truth(const TruthFiles& files, cv::Size size) {
  GroundTruth truth;
  std::vector<std::string>& warnings = truth.warnings;
  truth.disparity = read_truth(files.disparity, size, warnings);
  truth.reverse = read_truth(files.reverse, size, warnings, true);
  truth.objects = read_mask_of(files.objects, MaskUse::objects, size, warnings);
  truth.non_occluded = read_mask_of(files.non_occluded, MaskUse::judged, size, warnings);
  if (!truth.non_occluded.empty() || truth.disparity.empty()) return truth;
  const cv::Mat1f visible = read_truth(files.visible, size, warnings);
  if (!visible.empty()) {
    truth.non_occluded = mask_of_visible(truth.disparity, visible);
  } else if (!truth.reverse.empty()) {
    truth.non_occluded = cross_check(truth.disparity, truth.reverse);
  }
  return truth;
}

}  // namespace xgm
