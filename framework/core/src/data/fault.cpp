// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/fault.hpp"

#include <cmath>
#include <limits>

#include "data/first_pixel.hpp"

namespace xgm {
namespace {

bool is_finite(float value) { return std::abs(value) <= std::numeric_limits<float>::max(); }

/// Whether this is a map of such numbers; a cv::Mat1f may hold other ones if it was written to as
/// cv::Mat.
template <class Number>
bool is_map(const cv::Mat_<Number>& map, cv::Size size) {
  const cv::Mat& held = map;  // a cv::Mat_ says what it should hold
  return held.dims == 2 && held.type() == cv::traits::Type<Number>::value && held.size() == size;
}

std::optional<Fault> fault_of(const Image& image, cv::Size size) {
  if (image.planes.size() != 1 && image.planes.size() != 3) {
    return Fault{"an image does not have one or three planes"};
  }
  bool sized = image.valid.empty() || is_map(image.valid, size);
  for (const cv::Mat1f& plane : image.planes) sized = sized && is_map(plane, size);
  if (!sized) return Fault{"planes or masks do not have the base image's size"};
  for (const cv::Mat1f& plane : image.planes) {
    const auto pixel = first_pixel(size, [&](int y) {
      return [level = plane[y], valid = image.valid.empty() ? nullptr : image.valid[y]](int x) {
        return !is_finite(level[x]) && (valid == nullptr || valid[x] != 0);
      };
    });
    if (pixel) return Fault{"a valid pixel has no finite level", pixel};
  }
  return std::nullopt;
}

/// The rules of single pixels of a map. All are asked of all pixels: none of them branches.
class PixelRules {
 public:
  explicit PixelRules(const MapBounds& bounds)
      : known_(bounds.searched.has_value()), width_(static_cast<float>(bounds.size.width)) {
    if (!known_) return;
    low_ = static_cast<float>(bounds.searched->begin) - 1;
    high_ = static_cast<float>(bounds.searched->end);
    if (bounds.searched->empty()) high_ = low_;
  }

  bool is_no_status(std::uint8_t status) const { return status >= kStatusCount; }
  bool disagrees(float disparity, std::uint8_t status) const {
    return is_finite(disparity) != has_disparity(static_cast<Status>(status));
  }
  bool is_outside(float disparity, std::uint8_t status) const {
    const bool matched = status == static_cast<std::uint8_t>(Status::matched);
    const bool filled = status == static_cast<std::uint8_t>(Status::filled);
    const bool in_range = static_cast<bool>((disparity > low_) & (disparity < high_));
    return known_ & ((matched & !in_range) | (filled & !(std::abs(disparity) < width_)));
  }

 private:
  bool known_;
  float low_ = 0, high_ = 0, width_;
};

}  // namespace

std::string to_string(const Fault& fault) {
  if (!fault.pixel) return fault.rule;
  return fault.rule + " (x " + std::to_string(fault.pixel->x) + ", y " +
         std::to_string(fault.pixel->y) + ")";
}

std::optional<Fault> fault_of(const ImagePair& pair, cv::Size size) {
  for (const Image* image : {&pair.base, &pair.match}) {
    if (auto fault = fault_of(*image, size)) return fault;
  }
  if (pair.base.planes.size() == pair.match.planes.size()) return std::nullopt;
  return Fault{"one image is grey and the other in colour"};
}

std::optional<Fault> fault_of_confidence(const cv::Mat1f& confidence, cv::Size size) {
  if (!is_map(confidence, size)) return Fault{"the confidence does not have the image's size"};
  const auto pixel = first_pixel(size, [&](int y) {
    return [sure = confidence[y]](int x) { return (int{sure[x] < 0} | int{sure[x] > 1}) != 0; };
  });
  if (!pixel) return std::nullopt;
  return Fault{"a confidence is not in 0 to 1", pixel};
}

std::optional<Fault> fault_of(const DisparityMap& map, const MapBounds& bounds) {
  if (!is_map(map.disparity, bounds.size) || !is_map(map.status, bounds.size)) {
    return Fault{"the map does not have the image's size"};
  }
  if (!map.confidence.empty()) {
    if (auto fault = fault_of_confidence(map.confidence, bounds.size)) return fault;
  }
  const PixelRules rules(bounds);
  const auto pixel = first_pixel(bounds.size, [&](int y) {
    return [&rules, disparity = map.disparity[y], status = map.status[y]](int x) {
      // As numbers: all are looked at, without a branch.
      return (int{rules.is_no_status(status[x])} | int{rules.disagrees(disparity[x], status[x])} |
              int{rules.is_outside(disparity[x], status[x])}) != 0;
    };
  });
  if (!pixel) return std::nullopt;
  const std::uint8_t status = map.status(*pixel);
  if (rules.is_no_status(status)) return Fault{"the status is none there is", pixel};
  if (rules.disagrees(map.disparity(*pixel), status)) {
    return Fault{"disparity and status disagree on whether there is one", pixel};
  }
  return Fault{"a disparity lies outside the range", pixel};
}

}  // namespace xgm
