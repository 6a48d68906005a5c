// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/joint_bilateral/weights.hpp"

#include <cmath>

#include "plugins/filter/joint_bilateral/votes.hpp"

namespace xgm::joint_bilateral {
namespace {

double gauss(double squared_distance, double sigma) {
  return std::exp(-squared_distance / (2 * sigma * sigma));
}

}  // namespace

Weights::Weights(int radius, double sigma_space, double sigma_range)
    : radius_(radius), space_(2 * radius + 1, 2 * radius + 1) {
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      space_(dy + radius, dx + radius) =
          static_cast<float>(kFullWeight * gauss(dx * dx + dy * dy, sigma_space));
    }
  }
  constexpr double kSmallest = 0.5 / kFullWeight;  // below it every weight is rounded to zero
  constexpr int kLargestDistance = 255;            // grey levels
  for (int step = 0; step <= kLargestDistance * kSteps; ++step) {
    const double distance = static_cast<double>(step) / kSteps;
    const double weight = gauss(distance * distance, sigma_range);
    if (weight < kSmallest) break;
    range_.push_back(static_cast<float>(weight));
  }
}

}  // namespace xgm::joint_bilateral
