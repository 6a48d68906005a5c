// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/candidate_costs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

constexpr int kCensusRadius = 3;
constexpr float kCensusLimit = 24;  // differing bits of 48, as many as noise has
constexpr float kLevelLimit = 20;   // grey levels
constexpr float kSameSurface = 1;   // px

/// Grey levels with a border; NaN where there are no data.
cv::Mat1f framed(const cv::Mat1f& grey, const Image& image) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  cv::Mat1f frame(grey.rows + 2 * kCensusRadius, grey.cols + 2 * kCensusRadius, kNone);
  grey.copyTo(frame(cv::Rect({kCensusRadius, kCensusRadius}, grey.size())), image.valid);
  return frame;
}

/// A bit for each neighbour within 7x7 pixels that is darker than the pixel; 0 for those without
/// data, as comparisons with NaN are false.
std::vector<std::uint64_t> census(const cv::Mat1f& grey, const Image& image) {
  constexpr int kSide = 2 * kCensusRadius + 1;
  const cv::Mat1f frame = framed(grey, image);
  const auto width = static_cast<std::size_t>(grey.cols);
  std::vector<std::uint64_t> bits(grey.total(), 0);
  parallel_for(0, grey.rows, [&](int y) {
    std::uint64_t* const row = bits.data() + static_cast<std::size_t>(y) * width;
    const float* const centre = frame[y + kCensusRadius] + kCensusRadius;
    // A row of neighbours at a time, in as many bits as a level has: so the loop has vectors.
    std::vector<std::uint32_t> some(width);
    for (int dy = 0; dy < kSide; ++dy) {
      const float* const neighbour = frame[y + dy];
      for (std::size_t x = 0; x < width; ++x) {
        std::uint32_t darker = 0;
        for (int dx = 0; dx < kSide; ++dx) {
          darker = 2 * darker + (neighbour[x + static_cast<std::size_t>(dx)] < centre[x] ? 1U : 0U);
        }
        some[x] = darker;
      }
      for (std::size_t x = 0; x < width; ++x) row[x] = row[x] << kSide | some[x];
    }
  });
  return bits;
}

}  // namespace

CandidateCosts::CandidateCosts(const DisparityMap& map, const ImagePair& pair,
                               const CostRules& rules)
    : rules_(rules),
      pair_(pair),
      base_(pair.base.grey()),
      match_(pair.match.grey()),
      base_census_(census(base_, pair.base)),
      match_census_(census(match_, pair.match)),
      claimed_(map.size(), std::numeric_limits<float>::quiet_NaN()) {
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (!map.has_disparity(y, x)) continue;
      const float disparity = map.disparity(y, x);
      const int there = cvRound(static_cast<float>(x) - disparity);
      if (there < 0 || there >= map.size().width) continue;
      float& claimed = claimed_(y, there);
      if (std::isnan(claimed) || is_nearer(disparity, claimed)) claimed = disparity;
    }
  });
}

bool CandidateCosts::is_nearer(float a, float b) const {
  return rules_.near_is_high ? a > b : a < b;
}

/// Half by census, half by the grey levels, both truncated. `there`: the match pixel, rounded.
float CandidateCosts::matching_cost(cv::Point pixel, float disparity, int there) const {
  const auto row = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(match_.cols);
  const std::uint64_t base = base_census_[row + static_cast<std::size_t>(pixel.x)];
  const std::uint64_t match = match_census_[row + static_cast<std::size_t>(there)];
  const auto bits = static_cast<float>(std::popcount(base ^ match));
  const float* const levels = match_[pixel.y];
  const float exactly = static_cast<float>(pixel.x) - disparity;
  const int left = cvFloor(exactly);
  float level = levels[there];
  if (left >= 0 && left + 1 < match_.cols && pair_.match.is_valid(pixel.y, left) &&
      pair_.match.is_valid(pixel.y, left + 1)) {
    level = levels[left] + (exactly - static_cast<float>(left)) * (levels[left + 1] - levels[left]);
  }
  const float difference = std::abs(base_(pixel) - level);
  return std::min(bits / kCensusLimit, 1.0F) / 2 + std::min(difference / kLevelLimit, 1.0F) / 2;
}

float CandidateCosts::of(cv::Point pixel, const Candidate& candidate) const {
  constexpr float kPathLimit = 60;  // grey levels: beyond, colours tell nothing more
  const float disparity = candidate.disparity;
  const float path = rules_.path * std::min(candidate.path, kPathLimit);
  const int there = cvRound(static_cast<float>(pixel.x) - disparity);
  if (there < 0 || there >= match_.cols || !pair_.match.is_valid(pixel.y, there)) {
    return rules_.occlusion + path;
  }
  const float matching = matching_cost(pixel, disparity, there);
  const float claimed = claimed_(pixel.y, there);
  // Comparisons with NaN are false.
  if (!(std::abs(claimed - disparity) > kSameSurface)) return matching + path;
  if (is_nearer(claimed, disparity)) return std::min(matching, rules_.occlusion) + path;
  return matching + rules_.hides + path;
}

}  // namespace xgm::plane_filling
