// SPDX-License-Identifier: Apache-2.0
// Removes peaks: segments of the disparity map too small to be a surface.
#include "plugins/filter/peak_removal/segments.hpp"
#include "xgm/plugin.hpp"

namespace {

class PeakRemoval final : public xgm::Filter {
 public:
  struct Parameters {
    int min_size = 50;
    double max_difference = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("min_size", p.min_size,
            "Segments with fewer pixels lose their disparities and become peaks.")
        .unit("px")
        .range(1, 1e9);
    set.add("max_difference", p.max_difference,
            "Neighbours (left, right, above, below) whose disparities differ by at most this much "
            "belong to one segment.")
        .unit("px")
        .range(0, 1e6);
  }
  explicit PeakRemoval(Parameters p) : p_(p) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    const auto segments = xgm::peak_removal::find_segments(map.disparity, p_.max_difference);
    xgm::DisparityMap filtered = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      const auto row = static_cast<std::size_t>(y);
      for (std::size_t i = segments.row_begin[row]; i < segments.row_begin[row + 1]; ++i) {
        const xgm::peak_removal::Run& run = segments.runs[i];
        if (run.size >= p_.min_size) continue;
        for (int x = run.begin; x < run.end; ++x) filtered.invalidate(y, x, xgm::Status::peak);
      }
    });
    return filtered;
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<PeakRemoval>("peak_removal",
                            "Invalidates disparities that form segments of only a few pixels.",
                            "Hirschmueller, Stereo processing by semiglobal matching and mutual "
                            "information, PAMI 2008, section on removal of peaks");
}
