// SPDX-License-Identifier: Apache-2.0
// Search range of the paper's refined tMGM-16: local percentiles (section 5).
#include "plugins/search_range/window_statistics/window_ranks.hpp"
#include "xgm/plugin.hpp"

namespace {

/// As min_max, but a few outliers in a large window no longer widen the search. Pixels without a
/// disparity search all of the limits.
class Percentile final : public xgm::SearchRange {
 public:
  struct Parameters {
    int window = 41;
    double low = 5;
    double high = 95;
    int relaxation = 4;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window,
            "Side of the square, in pixels of the coarser level, whose disparities are ranked.")
        .unit("px")
        .range(1, 255)
        .odd();
    set.add("low", p.low, "Percentile of these disparities where the search begins (nearest rank).")
        .unit("%")
        .range(0, 100);
    set.add("high", p.high, "Percentile of these disparities where the search ends (nearest rank).")
        .unit("%")
        .range(0, 100);
    set.add("relaxation", p.relaxation,
            "How far, in pixels of the finer level, the search reaches beyond these percentiles.")
        .unit("px")
        .range(0, 1024);
    set.rule({"high", "low"}, "must not be below low", [&p] { return p.low <= p.high; });
  }

  explicit Percentile(Parameters parameters) : parameters_(parameters) {}

  xgm::DisparityRange run(const xgm::DisparityMap& coarse, const xgm::DisparityRange& limits,
                          const xgm::Context&) const override {
    namespace sr = xgm::search_range;
    const int relaxation = parameters_.relaxation;
    return sr::cut(sr::window_ranks(coarse, sr::valid_pixels(coarse), parameters_.window,
                                    {parameters_.low, parameters_.high}, relaxation),
                   limits, relaxation);
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Percentile>(
      "percentile",
      "Searches between two percentiles of the disparities found around each pixel of the coarser "
      "level; pixels without a disparity search everything.",
      "S. Patil, T. Prakash, B. Comandur, A. Kak: A comparative evaluation of SGM variants "
      "(including a new variant, tMGM) for dense stereo matching, section 5.");
}
