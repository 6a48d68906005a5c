// SPDX-License-Identifier: Apache-2.0
// A program of the user's as a filter.
#include <cmath>

#include "xgm/exchange/request.hpp"
#include "xgm/plugin.hpp"

namespace {

class External final : public xgm::Filter, public xgm::StatesNeeds {
 public:
  struct Parameters {
    xgm::exchange::Program program;
    xgm::exchange::ImageFiles images = xgm::exchange::ImageFiles::png;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    xgm::exchange::declare(p.program, set);
    xgm::exchange::declare(p.images, set);
  }

  explicit External(Parameters parameters) : p_(std::move(parameters)) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair& pair,
                        const xgm::Context& context) const override {
    if (context.run().rehearsal) return map.clone();
    xgm::exchange::Request question("filter", pair, p_.images, context);
    question.add(map);
    question.run(p_.program);
    return changed(map, question.disparities(), context.searched());
  }

  /// Of this process, for what it hands over; the program has memory of its own.
  xgm::Needs needs(const xgm::Workload& load) const override {
    return {.working = 2 * load.image_bytes() + 16 * load.pixels(), .updates = load.pixels()};
  }

 private:
  /// What lost its disparity is ambiguous, what got one is filled; what left the range that is
  /// searched has none. Masked pixels stay masked.
  static xgm::DisparityMap changed(const xgm::DisparityMap& map, const cv::Mat1f& disparities,
                                   std::optional<xgm::Interval> searched) {
    xgm::DisparityMap result = map.clone();
    const float low = searched ? static_cast<float>(searched->begin) - 1 : -INFINITY;
    const float high = searched ? static_cast<float>(searched->end) : INFINITY;
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        const float d = disparities(y, x);
        if (map.at(y, x) == xgm::Status::masked) continue;
        if (!std::isfinite(d)) {
          if (map.has_disparity(y, x)) result.invalidate(y, x, xgm::Status::ambiguous);
        } else if (!(d > low && d < high)) {
          result.invalidate(y, x, xgm::Status::out_of_range);
        } else {
          result.set(y, x, d, map.has_disparity(y, x) ? map.at(y, x) : xgm::Status::filled);
        }
      }
    }
    return result;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<External>("external",
                         "Runs a program of yours that changes a map; map and images are handed "
                         "over as files, see docs/external.md.");
}
