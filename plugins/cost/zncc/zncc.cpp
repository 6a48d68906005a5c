// SPDX-License-Identifier: Apache-2.0
// Cost "zncc": windows are compared by their correlation, which no gain or offset of the grey
// levels changes.
#include <algorithm>

#include "plugins/cost/candidate_costs/candidates.hpp"
#include "plugins/cost/zncc/correlation.hpp"
#include "xgm/plugin.hpp"

namespace {

// Small enough for the sums of a tile to stay in the cache, and for ragged ranges to agree within.
const cv::Size kTile{64, 32};

class Zncc final : public xgm::Cost {
 public:
  struct Parameters {
    int window = 7;
    int scale = 100;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window, "Side of the square window.").unit("px").range(3, 31).odd();
    set.add("scale", p.scale,
            "Cost at correlation -1; correlation 1 costs 0, and 0 (or a flat window) half of this.")
        .range(1, 254);
  }

  explicit Zncc(const Parameters& p) : window_(p.window), scale_(p.scale) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const xgm::ImagePair pair = xgm::cost::comparable(images);
    xgm::CostVolume costs(shape, scale_);
    std::fill_n(costs.data(), shape->cells(), xgm::CostVolume::kNoMatch);
    const cv::Rect image({0, 0}, shape->size());
    const int columns = (image.width + kTile.width - 1) / kTile.width;
    const int rows = (image.height + kTile.height - 1) / kTile.height;
    xgm::parallel_for(0, columns * rows, [&](int i) {
      const cv::Point corner(i % columns * kTile.width, i / columns * kTile.height);
      fill_tile(pair, cv::Rect(corner, kTile) & image, costs);
    });
    return costs;
  }

 private:
  void fill_tile(const xgm::ImagePair& pair, cv::Rect tile, xgm::CostVolume& costs) const {
    xgm::zncc::Correlator correlator(pair, tile, window_);
    const xgm::Interval searched = hull(costs.shape(), tile);
    for (int d = searched.begin; d < searched.end; ++d) {
      const cv::Mat1d& correlation = correlator.at(d);
      for (int y = 0; y < tile.height; ++y) {
        for (int x = 0; x < tile.width; ++x) {
          set(costs, pair.match, tile.y + y, tile.x + x, d, correlation(y, x));
        }
      }
    }
  }

  /// Smallest interval that holds the ranges of the tile, as far as they meet the match image.
  static xgm::Interval hull(const xgm::VolumeShape& shape, cv::Rect tile) {
    xgm::Interval result{shape.hull().end, shape.hull().begin};
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
      for (int x = tile.x; x < tile.x + tile.width; ++x) {
        if (shape.count(y, x) == 0) continue;
        result.begin = std::min(result.begin, shape.begin(y, x));
        result.end = std::max(result.end, shape.end(y, x));
      }
    }
    return xgm::intersect(result, {tile.x - shape.width() + 1, tile.x + tile.width});
  }

  void set(xgm::CostVolume& costs, const xgm::Image& match, int y, int x, int d,
           double correlation) const {
    const xgm::VolumeShape& shape = costs.shape();
    const bool inside = x - d >= 0 && x - d < shape.width();
    const bool searched = d >= shape.begin(y, x) && d < shape.end(y, x);
    if (!inside || !searched || !match.is_valid(y, x - d)) return;
    costs.at(y, x)[d - shape.begin(y, x)] =
        static_cast<std::uint8_t>(scale_ * (1 - correlation) / 2 + 0.5);
  }

  int window_;
  int scale_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Zncc>("zncc",
                     "Zero-mean normalised cross-correlation of windows, mean over channels.",
                     "Faugeras et al., Real time correlation-based stereo: algorithm, "
                     "implementations and applications, INRIA 1993");
}
