// SPDX-License-Identifier: Apache-2.0
#include "plugins/fuser/candidate_features/features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plugins/fuser/candidate_features/windows.hpp"

namespace xgm::fuser {
namespace {

constexpr std::array kOfCost{"", ", 3x3", ", 7x7", ", 3x3, above the lowest",
                             ", 7x7, above the lowest"};
constexpr std::array kOfMatcher{"share of alike pixels near by that have it in its own map",
                                "share of alike pixels near by that agree and have it",
                                "share of alike pixels in a wide window that agree and have it",
                                "range of its map in 5x5",
                                "steps to the nearest pixel without a match",
                                "disparity plus that of the other view",
                                "disparity above the middle one"};
constexpr std::array kOfPixel{
    "deviation of grey levels in 5x5", "horizontal gradient",  "range of grey levels in 9x9",
    "range of the candidates",         "number of candidates", "alike pixels near by that agree"};

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Appends features as bytes: `zero` is the byte of 0, `step` the value of one more.
class Bytes {
 public:
  explicit Bytes(std::uint8_t* at) : at_(at) {}
  void add(float value, float step, float zero) {
    const float byte = std::clamp(std::floor(value / step + 0.5F) + zero, 1.0F, 255.0F);
    *at_++ = std::isnan(value) ? std::uint8_t{0} : static_cast<std::uint8_t>(byte);
  }
  void add_share(float value) { add(value, 1.0F / 254, 1); }
  void add_difference(float value) { add(value, 0.125F, 128); }

 private:
  std::uint8_t* at_;
};

/// The map of the other view that a matcher is compared with: its own or, if it gives none, the
/// first that there is.
const DisparityMap* other_view(const Candidates& candidates, int matcher) {
  const std::vector<DisparityMap>& others = candidates.others;
  const auto is_there = [](const DisparityMap& map) { return !map.disparity.empty(); };
  const DisparityMap& own = others[static_cast<std::size_t>(matcher)];
  if (is_there(own)) return &own;
  const auto first = std::find_if(others.begin(), others.end(), is_there);
  return first == others.end() ? nullptr : &*first;
}

/// 0 if both views say the same.
float other_view_sum(const Candidates& candidates, int matcher, int y, int x) {
  const DisparityMap* other = other_view(candidates, matcher);
  if (other == nullptr) return kUnknown;
  const float d = candidates.maps[static_cast<std::size_t>(matcher)].disparity(y, x);
  const float there = std::floor(static_cast<float>(x) - d + 0.5F);
  if (!(there >= 0 && there < static_cast<float>(other->size().width))) return kUnknown;
  return d + other->disparity(y, static_cast<int>(there));
}

/// What the features of a matcher are told from.
struct Pixel {
  const CandidateMaps& maps;
  int y, x;
  AlikePixels near_by, wide;

  float disparity(int matcher) const {
    return maps.candidates.maps[static_cast<std::size_t>(matcher)].disparity(y, x);
  }
};

/// The disparities that there are, in ascending order.
std::vector<float> sorted_disparities(const Pixel& pixel) {
  std::vector<float> all;
  for (int i = 0; i < pixel.maps.matchers(); ++i) {
    if (!std::isnan(pixel.disparity(i))) all.push_back(pixel.disparity(i));
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Mean costs in 3x3 and 7x7 of one matcher after the other, for one of the costs.
struct MeanCosts {
  std::vector<float> small, large;
  float lowest_small = kUnknown, lowest_large = kUnknown;
};

MeanCosts mean_costs(const Pixel& pixel, int k) {
  MeanCosts means;
  for (int i = 0; i < pixel.maps.matchers(); ++i) {
    const bool known = !std::isnan(pixel.disparity(i));
    const cv::Mat1b& costs = pixel.maps.cost(i, k);
    means.small.push_back(known ? mean_cost(costs, pixel.y, pixel.x, 1) : kUnknown);
    means.large.push_back(known ? mean_cost(costs, pixel.y, pixel.x, 3) : kUnknown);
    means.lowest_small = std::fmin(means.lowest_small, means.small.back());
    means.lowest_large = std::fmin(means.lowest_large, means.large.back());
  }
  return means;
}

void add_costs(const Pixel& pixel, const MeanCosts& means, int matcher, int k, Bytes& bytes) {
  const auto i = static_cast<std::size_t>(matcher);
  const int own = pixel.maps.cost(matcher, k)(pixel.y, pixel.x);
  bytes.add(own == kNoCost ? kUnknown : static_cast<float>(own), 1, 1);
  bytes.add(means.small[i], 1, 1);
  bytes.add(means.large[i], 1, 1);
  bytes.add(means.small[i] - means.lowest_small, 1, 1);
  bytes.add(means.large[i] - means.lowest_large, 1, 1);
}

void add_matcher(const Pixel& pixel, int matcher, float middle, Bytes& bytes) {
  const auto& [maps, y, x, near_by, wide] = pixel;
  const float d = pixel.disparity(matcher);
  const DisparityMap& map = maps.candidates.maps[static_cast<std::size_t>(matcher)];
  const int hole = maps.hole_distance[static_cast<std::size_t>(matcher)](y, x);
  bytes.add_share(near_by.share(map.disparity, d));
  bytes.add_share(near_by.share(maps.agreed, d));
  bytes.add_share(wide.share(maps.agreed, d));
  bytes.add(range_of(map.disparity, maps.pair.base.valid, y, x, 2), 0.125F, 1);
  bytes.add(static_cast<float>(hole), 1, 1);
  bytes.add_difference(other_view_sum(maps.candidates, matcher, y, x));
  bytes.add_difference(d - middle);
}

void add_pixel(const Pixel& pixel, const std::vector<float>& sorted, Bytes& bytes) {
  const auto& [maps, y, x, near_by, wide] = pixel;
  const Image& image = maps.pair.base;
  bytes.add(deviation(maps.grey, image, y, x, 2), 0.25F, 1);
  bytes.add(gradient(maps.grey, image, y, x), 1, 1);
  bytes.add(range_of(maps.grey, image.valid, y, x, 4), 1, 1);
  bytes.add(sorted.back() - sorted.front(), 0.125F, 1);
  bytes.add(static_cast<float>(sorted.size()), 1, 1);
  bytes.add_share(near_by.share_known(maps.agreed));
}

}  // namespace

int FeatureLayout::count() const {
  constexpr int kPerCost = kOfCost.size(), kPerMatcher = kOfMatcher.size();
  constexpr int kPerPixel = kOfPixel.size();
  const int pairs = matchers * (matchers - 1) / 2;
  return matchers * (costs * kPerCost + kPerMatcher) + pairs + kPerPixel;
}

std::vector<std::string> FeatureLayout::names() const {
  std::vector<std::string> all;
  for (int i = 1; i <= matchers; ++i) {
    const std::string matcher = "matcher " + std::to_string(i);
    for (int k = 1; k <= costs; ++k) {
      for (const char* name : kOfCost) {
        all.push_back(matcher + ": cost " + std::to_string(k) + name);
      }
    }
    for (const char* name : kOfMatcher) all.push_back(matcher + ": " + name);
  }
  for (int i = 1; i <= matchers; ++i) {
    for (int j = i + 1; j <= matchers; ++j) {
      all.push_back("matcher " + std::to_string(i) + " less matcher " + std::to_string(j));
    }
  }
  all.insert(all.end(), kOfPixel.begin(), kOfPixel.end());
  return all;
}

void features_at(const CandidateMaps& maps, int y, int x, std::uint8_t* features) {
  const Pixel pixel{maps, y, x, AlikePixels(maps.pair.base, y, x, 4, 1),
                    AlikePixels(maps.pair.base, y, x, 10, 2)};
  Bytes bytes(features);
  std::vector<MeanCosts> means;
  for (int k = 0; k < maps.costs_per_matcher; ++k) means.push_back(mean_costs(pixel, k));
  const std::vector<float> sorted = sorted_disparities(pixel);
  const float middle = sorted[(sorted.size() - 1) / 2];
  for (int i = 0; i < maps.matchers(); ++i) {
    for (int k = 0; k < maps.costs_per_matcher; ++k) {
      add_costs(pixel, means[static_cast<std::size_t>(k)], i, k, bytes);
    }
    add_matcher(pixel, i, middle, bytes);
  }
  for (int i = 0; i < maps.matchers(); ++i) {
    for (int j = i + 1; j < maps.matchers(); ++j) {
      bytes.add_difference(pixel.disparity(i) - pixel.disparity(j));
    }
  }
  add_pixel(pixel, sorted, bytes);
}

}  // namespace xgm::fuser
