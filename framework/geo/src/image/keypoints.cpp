// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/keypoints.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <optional>

#include "xgm/geo/image/resample.hpp"

namespace xgm::geo {
namespace {

constexpr int kMaxKeypoints = 5000;
constexpr float kMaxRatio = 0.8F;  // of the best distance to the second best; Lowe, Section 7.1

struct Features {
  std::vector<cv::KeyPoint> points;  // in pixels of the image
  cv::Mat descriptors;
};

Features find_features(const SatelliteImage& image, const cv::Rect& window) {
  const cv::Mat1f grey = read_window(image, window);
  const GreyScale scale = find_grey_scale(image);
  const double gain = 255 / std::max(scale.white - scale.black, 1e-9);
  const cv::Mat mask = grey == grey;  // false for NaN
  cv::Mat picture;
  cv::Mat1f known = grey.clone();
  known.setTo(scale.black, ~mask);
  known.convertTo(picture, CV_8U, gain, -scale.black * gain);
  Features features;
  cv::SIFT::create(kMaxKeypoints)
      ->detectAndCompute(picture, mask, features.points, features.descriptors);
  for (cv::KeyPoint& point : features.points) {
    point.pt += cv::Point2f(static_cast<float>(window.x), static_cast<float>(window.y));
  }
  return features;
}

/// Where the ground of a window can be seen by the other camera.
cv::Rect seen_by(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect& window,
                 const HeightInterval& heights, double around) {
  cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  for (int k = 0; k < 18; ++k) {
    const cv::Point2d pixel(window.x + window.width * (k % 3) / 2.0,
                            window.y + window.height * (k / 3 % 3) / 2.0);
    const auto point = base.camera.localize(pixel, k < 9 ? heights.min : heights.max);
    if (!point) continue;
    const cv::Point2d p = match.camera.project(*point);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (!(low.x <= high.x)) return {};
  const cv::Rect2d box(low - cv::Point2d(around, around), high + cv::Point2d(around, around));
  const cv::Rect2d inside = box & cv::Rect2d({}, cv::Size2d(match.size));
  return cv::Rect(inside) & cv::Rect({}, match.size);
}

/// What a match lies beside the epipolar line of its base pixel; empty if the line is not known or
/// the match lies beyond its ends.
std::optional<KeypointMatch> place(const RpcCamera& base, const RpcCamera& match,
                                   const HeightInterval& heights, cv::Point2d here,
                                   cv::Point2d there) {
  const auto low = base.localize(here, heights.min), high = base.localize(here, heights.max);
  if (!low || !high) return std::nullopt;
  const cv::Point2d begin = match.project(*low), line = match.project(*high) - begin;
  const double length = cv::norm(line);
  if (length < 1e-6) return std::nullopt;
  const cv::Vec2d along(line.x / length, line.y / length), normal(-along[1], along[0]);
  const cv::Vec2d from(there.x - begin.x, there.y - begin.y);
  const double share = from.dot(along) / length;
  if (share < -0.05 || share > 1.05) return std::nullopt;
  return KeypointMatch{here, there, from.dot(normal), normal};
}

}  // namespace

std::vector<KeypointMatch> match_keypoints(const SatelliteImage& base, const SatelliteImage& match,
                                           const cv::Rect& window, const HeightInterval& heights,
                                           double max_offset) {
  const cv::Rect other = seen_by(base, match, window, heights, 2 * max_offset);
  if (other.empty()) return {};
  const Features here = find_features(base, window), there = find_features(match, other);
  if (here.points.empty() || there.points.size() < 2) return {};
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_L2).knnMatch(here.descriptors, there.descriptors, nearest, 2);
  std::vector<KeypointMatch> matches;
  for (const auto& two : nearest) {
    if (two.size() < 2 || two[0].distance > kMaxRatio * two[1].distance) continue;
    const auto found = place(base.camera, match.camera, heights,
                             here.points[static_cast<std::size_t>(two[0].queryIdx)].pt,
                             there.points[static_cast<std::size_t>(two[0].trainIdx)].pt);
    if (found && std::abs(found->across) <= max_offset) matches.push_back(*found);
  }
  return matches;
}

}  // namespace xgm::geo
