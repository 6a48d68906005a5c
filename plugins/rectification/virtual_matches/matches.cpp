// SPDX-License-Identifier: Apache-2.0
#include "plugins/rectification/virtual_matches/matches.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::geo {
namespace {

constexpr double kMinSide = 64;    // px
constexpr double kMinHeight = 20;  // m

/// Middle and half length of what is looked at.
struct Span {
  double middle, half;
  double at(int i, int count) const { return middle + half * (2.0 * i / (count - 1) - 1); }
};

Span span_of(double begin, double end, double least) {
  return {(begin + end) / 2, std::max(end - begin, least) / 2};
}

void require_sound(const SatelliteImage& base, const cv::Rect& window,
                   const HeightInterval& heights) {
  if (window.empty()) {
    throw Error(base.file + ": the window to rectify is empty; choose one of at least a pixel");
  }
  if (!std::isfinite(heights.min) || !std::isfinite(heights.max) || heights.min > heights.max) {
    throw Error(base.file + ": there are no heights from " + std::to_string(heights.min) + " to " +
                std::to_string(heights.max) + " m to rectify for; check the range prior");
  }
}

/// Height must move what the other camera sees, or there is no epipolar line.
void require_parallax(const SatelliteImage& base, const SatelliteImage& match, cv::Point2d pixel,
                      const Span& heights) {
  constexpr double kLeast = 1e-3;  // px per m
  const auto low = base.camera.localize(pixel, heights.at(0, 2));
  const auto high = base.camera.localize(pixel, heights.at(1, 2));
  if (!low || !high) return;
  const double moved = cv::norm(match.camera.project(*high) - match.camera.project(*low));
  if (!(moved < kLeast * 2 * heights.half)) return;
  throw Error(base.file + ", " + match.file +
              ": the cameras look along the same lines, so that heights cannot be told; choose a "
              "pair with a larger convergence angle");
}

}  // namespace

std::vector<VirtualMatch> virtual_matches(const SatelliteImage& base, const SatelliteImage& match,
                                          const cv::Rect& window, const HeightInterval& heights) {
  require_sound(base, window, heights);
  const Span x = span_of(window.x, window.br().x - 1.0, kMinSide);
  const Span y = span_of(window.y, window.br().y - 1.0, kMinSide);
  const Span h = span_of(heights.min, heights.max, kMinHeight);
  require_parallax(base, match, {x.middle, y.middle}, h);
  std::vector<VirtualMatch> matches;
  for (int k = 0; k < kPlaces * kPlaces * kHeights; ++k) {
    const int level = k / kPlaces / kPlaces;
    const cv::Point2d pixel(x.at(k % kPlaces, kPlaces), y.at(k / kPlaces % kPlaces, kPlaces));
    const auto point = base.camera.localize(pixel, h.at(level, kHeights));
    if (!point) continue;
    const cv::Point2d there = match.camera.project(*point);
    if (std::isfinite(there.x) && std::isfinite(there.y)) matches.push_back({pixel, there, level});
  }
  if (matches.size() < kPlaces * kPlaces * kHeights / 2) {
    throw Error(base.file + ": its camera reaches no ground of " + std::to_string(heights.min) +
                " to " + std::to_string(heights.max) +
                " m in most of the window; choose one that the image shows");
  }
  return matches;
}

cv::Rect frame(const Rectification& geometry, const std::vector<VirtualMatch>& matches,
               const cv::Rect& window) {
  double reach = 0;
  for (const VirtualMatch& m : matches) {
    reach =
        std::max(reach, std::abs(geometry.from_base(m.base).x - geometry.from_match(m.match).x));
  }
  constexpr int kSteps = 32;  // borders may be curved
  cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  const cv::Point2d first = window.tl(), last = cv::Point2d(window.br()) - cv::Point2d(1, 1);
  for (int k = 0; k <= kSteps; ++k) {
    const cv::Point2d here = first + (last - first) * (k / double{kSteps});
    for (const cv::Point2d border : {cv::Point2d(here.x, first.y), cv::Point2d(here.x, last.y),
                                     cv::Point2d(first.x, here.y), cv::Point2d(last.x, here.y)}) {
      const cv::Point2d p = geometry.from_base(border);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const cv::Point corner(cvFloor(low.x - reach), cvFloor(low.y));
  return {corner, cv::Size(cvCeil(high.x + reach) - corner.x + 1, cvCeil(high.y) - corner.y + 1)};
}

double residual_of(const Rectification& geometry, const std::vector<VirtualMatch>& matches) {
  double sum = 0;
  for (const VirtualMatch& m : matches) {
    sum += std::pow(geometry.from_base(m.base).y - geometry.from_match(m.match).y, 2);
  }
  return std::sqrt(sum / static_cast<double>(matches.size()));
}

}  // namespace xgm::geo
