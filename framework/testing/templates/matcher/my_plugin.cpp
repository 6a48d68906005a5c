// SPDX-License-Identifier: Apache-2.0
// Matcher "my_plugin": block matching by the mean absolute difference in a window.
#include <cmath>
#include <limits>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Matcher {
 public:
  struct Parameters {
    int window = 5;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window, "Side of the window.").unit("px").range(1, 51).odd();
  }
  explicit MyPlugin(Parameters p) : radius_(p.window / 2) {}

  xgm::MatchResult run(const xgm::MatchRequest& request, const xgm::Context&) const override {
    const Views views{request.pair, request.pair.base.grey(), request.pair.match.grey()};
    xgm::DisparityMap map(request.pair.size());  // out_of_range everywhere
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) match(views, request.range.at(y, x), y, x, map);
    });
    return {map, std::nullopt};
  }

 private:
  struct Views {
    const xgm::ImagePair& pair;
    cv::Mat1f base, match;
  };

  void match(const Views& views, xgm::Interval searched, int y, int x,
             xgm::DisparityMap& map) const {
    if (!views.pair.base.is_valid(y, x)) {
      map.invalidate(y, x, xgm::Status::masked);
      return;
    }
    float least = std::numeric_limits<float>::infinity();
    for (int d = searched.begin; d < searched.end; ++d) {
      const float difference = mean_difference(views, y, x, d);
      if (difference >= least) continue;
      least = difference;
      map.set(y, x, static_cast<float>(d));
    }
  }

  /// Of the pixels that both windows have; infinite if (x, y) has no counterpart.
  float mean_difference(const Views& views, int y, int x, int d) const {
    const cv::Rect image({0, 0}, views.pair.size());
    float sum = 0;
    int count = 0;
    const auto both = [&](int v, int u) {
      return image.contains({u, v}) && image.contains({u - d, v}) &&
             views.pair.base.is_valid(v, u) && views.pair.match.is_valid(v, u - d);
    };
    if (!both(y, x)) return std::numeric_limits<float>::infinity();
    for (int v = y - radius_; v <= y + radius_; ++v) {
      for (int u = x - radius_; u <= x + radius_; ++u) {
        if (!both(v, u)) continue;
        sum += std::abs(views.base(v, u) - views.match(v, u - d));
        ++count;
      }
    }
    return sum / static_cast<float>(count);
  }

  int radius_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Block matching by absolute differences.");
}
