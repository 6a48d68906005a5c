// SPDX-License-Identifier: Apache-2.0
// Random volumes and penalties for the tests of aggregations.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "support/support.hpp"

namespace xgm::testing {

/// Random tables and classes, different for each direction.
class RandomPenalties final : public PenaltyField {
 public:
  RandomPenalties(int base_classes, int match_classes, int p2_max, std::uint64_t seed)
      : base_classes_(base_classes), match_classes_(match_classes), p2_max_(p2_max), seed_(seed) {}

  PenaltyTable table(Direction r) const override {
    Random random = generator(r, -1);
    PenaltyTable table{base_classes_, match_classes_, {}};
    for (int i = 0; i < base_classes_ * match_classes_; ++i) {
      const int p2 = random.integer(0, p2_max_);
      table.entries.push_back({random.integer(0, p2), p2});
    }
    return table;
  }
  void classify(Direction r, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    Random random = generator(r, y);
    for (auto& each : base) each = static_cast<std::uint8_t>(random.integer(0, base_classes_ - 1));
    for (auto& each : match)
      each = static_cast<std::uint8_t>(random.integer(0, match_classes_ - 1));
  }

 private:
  Random generator(Direction r, int y) const {
    return Random(seed_ * 1000003 +
                  static_cast<std::uint64_t>((y + 1) * 25 + r.dx * 5 + r.dy + 12));
  }
  int base_classes_, match_classes_, p2_max_;
  std::uint64_t seed_;
};

/// P1 and P2 everywhere.
class ConstantPenalties final : public PenaltyField {
 public:
  ConstantPenalties(int p1, int p2) : pair_{p1, p2} {}
  PenaltyTable table(Direction) const override { return {1, 1, {pair_}}; }

 private:
  PenaltyPair pair_;
};

/// Costs 0..max_cost; kNoMatch where x - d is outside, in a tenth of the other cells, and in all
/// cells of a twentieth of the pixels.
inline CostVolume random_costs(const VolumeShapePtr& shape, int max_cost, std::uint64_t seed) {
  Random random(seed);
  CostVolume costs(shape, max_cost);
  for (int y = 0; y < shape->height(); ++y)
    for (int x = 0; x < shape->width(); ++x) {
      const bool dead = random.integer(1, 20) == 1;
      for (int i = 0; i < shape->count(y, x); ++i) {
        const int x_match = x - (shape->begin(y, x) + i);
        const bool outside = x_match < 0 || x_match >= shape->width();
        const int c = random.integer(0, max_cost);
        const bool hole = random.integer(1, 10) == 1;
        costs.at(y, x)[i] =
            dead || outside || hole ? CostVolume::kNoMatch : static_cast<std::uint8_t>(c);
      }
    }
  return costs;
}

inline VolumeShapePtr dense_shape(cv::Size size, Interval interval) {
  return std::make_shared<VolumeShape>(DisparityRange::uniform(size, interval));
}
/// Random ranges, a tenth of them empty, another tenth of the pixels masked.
inline VolumeShapePtr ragged_shape(cv::Size size, Interval hull, std::uint64_t seed) {
  return std::make_shared<VolumeShape>(random_range(size, hull, seed),
                                       random_mask(size, 0.1, seed + 1));
}

}  // namespace xgm::testing
