// SPDX-License-Identifier: Apache-2.0
// Exhaustive search. Distances are sums of whole numbers, so that they are exact in any order.
#include "plugins/preprocess/ransac_deskew/descriptors.hpp"

#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::ransac_deskew {
namespace {

constexpr int kNone = -1;

int squared_distance(const Descriptor& a, const Descriptor& b) {
  int sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto difference = static_cast<std::int16_t>(a[k] - b[k]);
    sum += difference * difference;
  }
  return sum;
}

/// The one that looks most like `wanted`, kNone if a second one looks nearly as much like it.
int best_match(const Descriptor& wanted, const std::vector<Descriptor>& among, double ratio) {
  int best = std::numeric_limits<int>::max(), second = best, place = kNone;
  for (std::size_t j = 0; j < among.size(); ++j) {
    const int distance = squared_distance(wanted, among[j]);
    if (distance >= second) continue;
    second = distance < best ? best : distance;
    if (distance >= best) continue;
    best = distance;
    place = static_cast<int>(j);
  }
  const auto length = [](int squared) {
    return static_cast<double>(std::sqrt(static_cast<float>(squared)));
  };
  return length(best) < ratio * length(second) ? place : kNone;
}

}  // namespace

void KeyPoints::add(cv::Point2f point, const float* descriptor) {
  at.push_back(point);
  Descriptor& whole = descriptors.emplace_back();
  for (std::size_t k = 0; k < whole.size(); ++k) {
    whole[k] = static_cast<std::int16_t>(descriptor[k]);
  }
}

void KeyPoints::add(const KeyPoints& others) {
  at.insert(at.end(), others.at.begin(), others.at.end());
  descriptors.insert(descriptors.end(), others.descriptors.begin(), others.descriptors.end());
}

std::vector<std::pair<std::size_t, std::size_t>> mutual_matches(const KeyPoints& base,
                                                                const KeyPoints& match,
                                                                double ratio) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (base.at.size() < 2 || match.at.size() < 2) return pairs;  // nothing to be clearly better than
  std::vector<int> partner(base.at.size(), kNone);
  parallel_for(0, static_cast<int>(base.at.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const int there = best_match(base.descriptors[k], match.descriptors, ratio);
    if (there == kNone) return;
    const Descriptor& found = match.descriptors[static_cast<std::size_t>(there)];
    if (best_match(found, base.descriptors, ratio) == i) partner[k] = there;
  });
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] != kNone) pairs.emplace_back(i, static_cast<std::size_t>(partner[i]));
  }
  return pairs;
}

}  // namespace xgm::ransac_deskew
