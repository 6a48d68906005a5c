// SPDX-License-Identifier: Apache-2.0
// What every cost is tested on: pairs and ranges of all sorts, and the comparison with an oracle.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "support/simd.hpp"
#include "support/support.hpp"

namespace xgm::testing {

struct CostCase {
  std::string name;
  ImagePair pair;
  DisparityRange range;
};

/// The unrounded cost of base pixel (y, x) and match pixel (y, x - d), in double, from the
/// definition. Asked only where both exist.
using CostOracle = std::function<double(const ImagePair&, int y, int x, int d)>;

/// Masks about a fifth of the pixels. Their values are NaN or darker than all others: nobody may
/// look at them.
inline void mask(Image& image, std::uint64_t seed) {
  image.valid = random_mask(image.size(), 0.2, seed);
  for (cv::Mat1f& plane : image.planes) {
    plane.setTo(-100, image.valid == 0);
    plane.setTo(std::numeric_limits<float>::quiet_NaN(),
                (image.valid == 0) & (random_mask(image.size(), 0.5, seed + 1) == 0));
  }
}

/// A noisy pair with a true disparity of 2. The match view differs a little, so that costs are
/// neither all 0 nor all random; fractions of a grey level only where `fractions`.
inline ImagePair noisy_pair(cv::Size size, int channels, bool masked, bool fractions) {
  ImagePair pair = shifted_pair(size, 2, 7, channels);
  Random random(11);
  for (cv::Mat1f& plane : pair.match.planes) {
    for (float& value : plane) {
      value += fractions ? static_cast<float>(random.real(-4, 4))
                         : static_cast<float>(random.integer(-4, 4));
    }
  }
  if (masked) {
    mask(pair.base, 3);
    mask(pair.match, 4);
  }
  return pair;
}

inline std::vector<CostCase> cost_cases(bool fractions) {
  std::vector<CostCase> cases;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 1), cv::Size(1, 7), cv::Size(2, 3),
                              cv::Size(13, 9), cv::Size(67, 34)}) {
    for (const int channels : {1, 3}) {
      for (const bool masked : {false, true}) {
        const ImagePair pair = noisy_pair(size, channels, masked, fractions);
        const auto add = [&](const std::string& what, const DisparityRange& range) {
          std::ostringstream name;
          name << size << ", " << channels << " channels, " << (masked ? "masked, " : "") << what;
          cases.push_back({name.str(), pair, range});
        };
        add("range across 0", DisparityRange::uniform(size, {-3, 6}));
        add("negative range", DisparityRange::uniform(size, {-9, -1}));
        add("one disparity", DisparityRange::uniform(size, {2, 3}));
        if (size.width < 20) {
          add("wider than the image", DisparityRange::uniform(size, {-20, 25}));
        }
        add("ragged", random_range(size, {-8, 11}, 5));
      }
    }
  }
  return cases;
}

/// Describes the first cell that is wrong; empty if none is. Where the exact cost is within
/// `tolerance` of a rounding threshold, both roundings are right.
inline std::string first_fault(const Cost& cost, const CostOracle& oracle, const CostCase& c,
                               double tolerance) {
  const auto shape = std::make_shared<const VolumeShape>(c.range, c.pair.base.valid);
  const CostVolume costs = cost.run(c.pair, shape, Context{});
  std::ostringstream fault;
  if (costs.max_cost < 0 || costs.max_cost > 254) fault << "max_cost is " << costs.max_cost;
  for (int y = 0; y < shape->height(); ++y) {
    for (int x = 0; x < shape->width(); ++x) {
      for (int i = 0; i < shape->count(y, x); ++i) {
        const int d = shape->begin(y, x) + i;
        const int cell = costs.at(y, x)[i];
        const bool exists = x - d >= 0 && x - d < shape->width() && c.pair.match.is_valid(y, x - d);
        const double exact = exists ? oracle(c.pair, y, x, d) : 255;
        const bool right = cell >= std::floor(exact + 0.5 - tolerance) &&
                           cell <= std::floor(exact + 0.5 + tolerance) &&
                           (cell <= costs.max_cost || !exists);
        if (right) continue;
        fault << c.name << ": C(" << x << ", " << y << "; " << d << ") is " << cell << ", not "
              << exact;
        return fault.str();
      }
    }
  }
  return fault.str();
}

/// Compares with the oracle on all cases, in whole grey levels and in fractions of them. `rounding`
/// bounds the error before rounding on whole grey levels.
inline void check_costs(const std::string& yaml, const CostOracle& oracle, double rounding = 0) {
  const auto cost = stage<Cost>(yaml);
  for (const CostCase& c : cost_cases(false)) CHECK(first_fault(*cost, oracle, c, rounding) == "");
  for (const CostCase& c : cost_cases(true)) CHECK(first_fault(*cost, oracle, c, 1e-3) == "");
}

/// C(p, d) of a pair equals C(p - d, -d) of the swapped pair.
inline void check_symmetry(const std::string& yaml) {
  const auto cost = stage<Cost>(yaml);
  for (const CostCase& c : cost_cases(false)) {
    if (!c.range.is_uniform()) continue;
    const auto shape = std::make_shared<const VolumeShape>(c.range, c.pair.base.valid);
    const auto back_shape =
        std::make_shared<const VolumeShape>(c.range.reversed(), c.pair.match.valid);
    const CostVolume costs = cost->run(c.pair, shape, Context{});
    const CostVolume back = cost->run(c.pair.swapped(), back_shape, Context{});
    int differences = 0;
    for (int y = 0; y < shape->height(); ++y) {
      for (int x = 0; x < shape->width(); ++x) {
        for (int d = shape->begin(y, x); d < shape->end(y, x); ++d) {
          const int other = x - d;
          if (other < 0 || other >= shape->width() || !c.pair.match.is_valid(y, other)) continue;
          const bool asked = back_shape->begin(y, other) <= -d && -d < back_shape->end(y, other);
          differences += !asked || costs.at(y, x)[d - shape->begin(y, x)] !=
                                       back.at(y, other)[-d - back_shape->begin(y, other)];
        }
      }
    }
    CHECK_MESSAGE(differences == 0, c.name);
  }
}

/// The same cells for any number of threads.
inline void check_threads(const std::string& yaml) {
  const auto cost = stage<Cost>(yaml);
  const ImagePair pair = noisy_pair({150, 70}, 3, true, true);
  const auto shape =
      std::make_shared<const VolumeShape>(random_range(pair.size(), {-8, 11}, 5), pair.base.valid);
  const auto run = [&](int count) {
    const xgm::ThreadLimit threads(count);
    return cost->run(pair, shape, Context{});
  };
  const CostVolume one = run(1);
  for (const int count : {2, 3, 8}) CHECK(identical(run(count), one));
}

/// Rows and slices longer than any vector, and all that makes them odd.
inline std::vector<CostCase> long_cases() {
  const cv::Size size(151, 3);
  std::vector<CostCase> cases;
  for (const int channels : {1, 3}) {
    for (const bool masked : {false, true}) {
      const ImagePair pair = noisy_pair(size, channels, masked, true);
      cases.push_back({"dense", pair, DisparityRange::uniform(size, {0, 117})});
      cases.push_back({"wider than the image", pair, DisparityRange::uniform(size, {-170, 200})});
      cases.push_back({"outside the image", pair, DisparityRange::uniform(size, {160, 195})});
      cases.push_back({"ragged", pair, random_range(size, {-70, 90}, 5)});
    }
  }
  return cases;
}

/// Every SIMD target writes the cells that the code without vectors writes, on short slices (on
/// which check_costs() holds one of them against the oracle) and on long ones.
inline void check_targets(const std::string& yaml) {
  const auto cost = stage<Cost>(yaml);
  std::vector<CostCase> cases = cost_cases(true);
  for (CostCase& c : long_cases()) cases.push_back(std::move(c));
  for (const CostCase& c : cases) {
    const auto shape = std::make_shared<const VolumeShape>(c.range, c.pair.base.valid);
    const SimdChoice choice("scalar");
    const CostVolume plain = cost->run(c.pair, shape, Context{});
    with_each_simd_target(
        [&] { CHECK_MESSAGE(identical(cost->run(c.pair, shape, Context{}), plain), c.name); });
  }
}

/// A pair of one grey and one colour view costs what the two grey views cost.
inline void check_mixed_views(const std::string& yaml) {
  const auto cost = stage<Cost>(yaml);
  ImagePair mixed = noisy_pair({13, 9}, 3, false, false);
  mixed.match.planes = {mixed.match.grey()};
  const ImagePair grey{Image(mixed.base.grey()), mixed.match};
  const auto shape =
      std::make_shared<const VolumeShape>(DisparityRange::uniform(mixed.size(), {-3, 6}));
  CHECK(identical(cost->run(mixed, shape, Context{}), cost->run(grey, shape, Context{})));
}

}  // namespace xgm::testing
