// SPDX-License-Identifier: Apache-2.0
// The median of the candidates that agree.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plugins/fuser/candidate_choice/choice.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace fuser = xgm::fuser;

/// A vote: of the groups of candidates that lie within the tolerance of one of them, the largest
/// (of equal ones, that of the first matcher). Its lower median is a disparity that a matcher has
/// found, where a mean may lie on no surface.
class Median final : public xgm::Fuser {
 public:
  struct Parameters {
    double tolerance = 1;
    int support = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("tolerance", p.tolerance, "Disparities this near to one of them agree with it.")
        .unit("px")
        .range(0, 1000);
    set.add("support", p.support,
            "So many matchers have to agree, the one itself included; elsewhere pixels become "
            "mismatched.")
        .range(1, 1000);
  }
  explicit Median(Parameters p)
      : tolerance_(static_cast<float>(p.tolerance)),
        support_(static_cast<std::size_t>(p.support)) {}

  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    cv::Mat1b alone(candidates.maps.front().size(), std::uint8_t{0});
    xgm::DisparityMap map = fuser::chosen(candidates, [&](int y, int x) {
      const std::vector<int> group = largest_group(candidates, y, x);
      if (group.empty()) return fuser::kNone;
      alone(y, x) = group.size() < support_ ? 1 : 0;
      return group[(group.size() - 1) / 2];
    });
    for (int y = 0; y < alone.rows; ++y) {
      for (int x = 0; x < alone.cols; ++x) {
        if (alone(y, x) != 0) map.invalidate(y, x, xgm::Status::mismatched);
      }
    }
    return map;
  }

 private:
  /// In the order of their disparities.
  std::vector<int> largest_group(const xgm::Candidates& candidates, int y, int x) const {
    const auto disparity = [&](int i) {
      return candidates.maps[static_cast<std::size_t>(i)].disparity(y, x);
    };
    const int count = static_cast<int>(candidates.maps.size());
    std::vector<int> largest;
    for (int i = 0; i < count; ++i) {
      std::vector<int> group;
      for (int j = 0; j < count; ++j) {  // what is NaN is near to nothing
        if (std::abs(disparity(j) - disparity(i)) <= tolerance_) group.push_back(j);
      }
      if (group.size() > largest.size()) largest = std::move(group);
    }
    std::stable_sort(largest.begin(), largest.end(),
                     [&](int i, int j) { return disparity(i) < disparity(j); });
    return largest;
  }

  float tolerance_;
  std::size_t support_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Median>("median", "The median of those disparities that agree with most others.");
}
