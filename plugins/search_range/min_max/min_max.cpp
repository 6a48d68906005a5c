// SPDX-License-Identifier: Apache-2.0
// Search range of the paper's tSGM and tMGM: local minimum and maximum (Eq. 7).
#include "plugins/search_range/window_statistics/window_extrema.hpp"
#include "xgm/plugin.hpp"

namespace {

/// Pixels without a disparity search all of the limits.
class MinMax final : public xgm::SearchRange {
 public:
  struct Parameters {
    int window = 7;
    int relaxation = 4;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window,
            "Side of the square, in pixels of the coarser level, whose smallest and largest "
            "disparity bound the search.")
        .unit("px")
        .range(1, 255)
        .odd();
    set.add("relaxation", p.relaxation,
            "How far, in pixels of the finer level, the search reaches beyond what the window "
            "holds (the paper's epsilon).")
        .unit("px")
        .range(0, 1024);
  }

  explicit MinMax(Parameters parameters) : parameters_(parameters) {}

  xgm::DisparityRange run(const xgm::DisparityMap& coarse, const xgm::DisparityRange& limits,
                          const xgm::Context&) const override {
    namespace sr = xgm::search_range;
    const int relaxation = parameters_.relaxation;
    return sr::cut(sr::window_extrema(coarse, parameters_.window, relaxation), limits, relaxation);
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MinMax>(
      "min_max",
      "Searches from the smallest to the largest disparity found around each pixel of the coarser "
      "level; pixels without a disparity search everything.",
      "S. Patil, T. Prakash, B. Comandur, A. Kak: A comparative evaluation of SGM variants "
      "(including a new variant, tMGM) for dense stereo matching, Eq. 7.");
}
