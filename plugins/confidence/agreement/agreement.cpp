// SPDX-License-Identifier: Apache-2.0
// How many of the pixels around have the disparity of the pixel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/plugin.hpp"

namespace {

/// Pixels of the window that have no disparity do not agree: where many are missing, the others are
/// not to be trusted either.
class Agreement final : public xgm::Confidence {
 public:
  struct Parameters {
    int window = 9;
    double max_difference = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window, "Side of the window.").unit("px").range(3, 101).odd();
    set.add("max_difference", p.max_difference,
            "Disparities that differ by no more agree with each other.")
        .unit("px")
        .range(0, 1000);
  }
  explicit Agreement(Parameters p) : p_(p) {}

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    const xgm::DisparityMap& map = evidence.map;
    cv::Mat1f confidence(map.size(), std::numeric_limits<float>::quiet_NaN());
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (map.at(y, x) == xgm::Status::matched) confidence(y, x) = share(map.disparity, y, x);
      }
    });
    return confidence;
  }

 private:
  /// Of the other pixels of the window that lie in the image; 1 if there are none.
  float share(const cv::Mat1f& disparity, int y, int x) const {
    const int radius = p_.window / 2;
    const cv::Rect window =
        cv::Rect(x - radius, y - radius, p_.window, p_.window) & cv::Rect({}, disparity.size());
    const double own = static_cast<double>(disparity(y, x));
    int agreeing = 0;
    for (int v = window.y; v < window.br().y; ++v) {
      const float* const row = disparity[v];
      for (int u = window.x; u < window.br().x; ++u) {
        agreeing += std::abs(row[u] - own) <= p_.max_difference ? 1 : 0;  // false of NaN
      }
    }
    const int others = window.area() - 1;
    return others == 0 ? 1 : static_cast<float>(agreeing - 1) / static_cast<float>(others);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Agreement>("agreement",
                          "The share of the pixels around that have about the same disparity.",
                          "M. Poggi, S. Mattoccia: Learning a general-purpose confidence measure "
                          "based on O(1) features "
                          "and a smarter aggregation strategy for semi global matching, 3DV 2016, "
                          "disparity agreement.");
}
