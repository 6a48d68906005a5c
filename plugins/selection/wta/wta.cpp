// SPDX-License-Identifier: Apache-2.0
// Winner takes all: the disparity with the lowest sum, if asked only where it clearly wins.
#include <algorithm>
#include <cstdlib>
#include <span>

#include "xgm/plugin.hpp"

namespace {

using xgm::Status;
using Sums = std::span<const std::uint16_t>;

constexpr std::uint16_t kNoMatch = xgm::AggregatedVolume::kNoMatch;

std::uint16_t lowest(Sums sums) {
  std::uint16_t low = kNoMatch;
  for (const std::uint16_t sum : sums) low = std::min(low, sum);
  return low;
}

/// Is every rival (a matchable cell that is not `best` or next to it) above the best by more than
/// `percent` of the pixel's contrast, the mean of its matchable sums less the lowest? In whole
/// numbers: (rival - low) * n * 100 > percent * (total - n * low).
bool clearly_wins(Sums sums, int best, int percent) {
  const std::int64_t low = sums[static_cast<std::size_t>(best)];
  std::int64_t n = 0, total = 0, rival = kNoMatch;
  for (int i = 0; i < static_cast<int>(sums.size()); ++i) {
    const std::uint16_t sum = sums[static_cast<std::size_t>(i)];
    if (sum == kNoMatch) continue;
    ++n;
    total += sum;
    if (std::abs(i - best) > 1) rival = std::min<std::int64_t>(rival, sum);
  }
  return rival == kNoMatch || (rival - low) * n * 100 > percent * (total - n * low);
}

class Wta final : public xgm::Selection {
 public:
  struct Parameters {
    int uniqueness = 0;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("uniqueness", p.uniqueness,
            "How clearly the best disparity must win, 0 for not at all: the sums of all "
            "disparities not next to it must exceed its own by more than this share of the "
            "pixel's contrast (mean sum less lowest sum), else the pixel becomes ambiguous.")
        .unit("%")
        .range(0, 100);
  }
  explicit Wta(Parameters p) : p_(p) {}

  xgm::DisparityMap run(const xgm::AggregatedVolume& sums, const xgm::Context&) const override {
    const xgm::VolumeShape& shape = sums.shape();
    xgm::DisparityMap map(shape.size(), Status::out_of_range);
    xgm::parallel_for(0, shape.height(), [&](int y) {
      for (int x = 0; x < shape.width(); ++x) {
        select({sums.at(y, x), static_cast<std::size_t>(shape.count(y, x))}, shape.begin(y, x), y,
               x, map);
      }
    });
    return map;
  }

 private:
  void select(Sums sums, int begin, int y, int x, xgm::DisparityMap& map) const {
    const std::uint16_t low = lowest(sums);
    if (low == kNoMatch) return;
    const auto best = static_cast<int>(std::find(sums.begin(), sums.end(), low) - sums.begin());
    if (p_.uniqueness > 0 && !clearly_wins(sums, best, p_.uniqueness)) {
      map.invalidate(y, x, Status::ambiguous);
    } else {
      map.set(y, x, static_cast<float>(begin + best));
    }
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Wta>(
      "wta", "Takes the disparity with the lowest sum; of equal ones the smallest disparity.",
      "Hirschmueller, Stereo processing by semiglobal matching and mutual "
      "information, PAMI 2008");
}
