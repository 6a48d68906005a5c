// SPDX-License-Identifier: Apache-2.0
// Search range of Rothermel's original tSGM, as the paper tells it (section 3.3).
#include <optional>

#include "plugins/search_range/window_statistics/window_extrema.hpp"
#include "plugins/search_range/window_statistics/window_ranks.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace sr = xgm::search_range;

/// Mean disparity of a map, none if it has no disparity at all.
std::optional<double> mean(const xgm::DisparityMap& map) {
  double sum = 0;
  std::int64_t count = 0;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (!map.has_disparity(y, x)) continue;
      sum += map.disparity(y, x);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

/// Pixels with a disparity: minimum and maximum of a small window. Others: `tau` around the median
/// of a large one, or around the mean of the whole map if the large window is empty too. A map
/// without any disparity leaves all of the limits to search.
class MedianWindow final : public xgm::SearchRange {
 public:
  struct Parameters {
    int window = 7;
    int relaxation = 4;
    int median_window = 31;
    int tau = 16;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window,
            "Side of the square, in pixels of the coarser level, whose smallest and largest "
            "disparity bound the search of pixels that have a disparity.")
        .unit("px")
        .range(1, 255)
        .odd();
    set.add("relaxation", p.relaxation,
            "How far, in pixels of the finer level, the search reaches beyond what that window "
            "holds.")
        .unit("px")
        .range(0, 1024);
    set.add("median_window", p.median_window,
            "Side of the square, in pixels of the coarser level, whose median is the centre of the "
            "search of pixels that have no disparity.")
        .unit("px")
        .range(1, 255)
        .odd();
    set.add("tau", p.tau,
            "How far, in pixels of the finer level, pixels without a disparity are searched to "
            "both sides of that median.")
        .unit("px")
        .range(0, 1024);
  }

  explicit MedianWindow(Parameters parameters) : parameters_(parameters) {}

  xgm::DisparityRange run(const xgm::DisparityMap& coarse, const xgm::DisparityRange& limits,
                          const xgm::Context&) const override {
    sr::Proposal proposal = sr::window_extrema(coarse, parameters_.window, parameters_.relaxation);
    fill_holes(proposal, coarse);
    return sr::cut(proposal, limits, parameters_.relaxation);
  }

 private:
  void fill_holes(sr::Proposal& proposal, const xgm::DisparityMap& coarse) const {
    const std::optional<double> average = mean(coarse);
    if (!average) return;
    const cv::Mat1b holes(~sr::valid_pixels(coarse));
    const sr::Proposal medians =
        sr::window_ranks(coarse, holes, parameters_.median_window, {50, 50}, parameters_.tau);
    const xgm::Interval around_average = sr::relaxed(*average, *average, parameters_.tau);
    for (int y = 0; y < holes.rows; ++y) {
      for (int x = 0; x < holes.cols; ++x) {
        if (holes(y, x) == 0) continue;
        const xgm::Interval median = medians.at(y, x);
        proposal.set(y, x, median.empty() ? around_average : median);
      }
    }
  }

  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MedianWindow>(
      "median_window",
      "Searches as min_max where the coarser level has a disparity, and around the median of a "
      "large window where it has none.",
      "M. Rothermel, K. Wenzel, D. Fritsch, N. Haala: SURE: Photogrammetric surface reconstruction "
      "from imagery, LC3D Workshop, 2012.");
}
