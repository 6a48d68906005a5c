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
    const cv::Mat1i sizes = xgm::peak_removal::segment_sizes(map.disparity, p_.max_difference);
    xgm::DisparityMap filtered = map.clone();
    for (int y = 0; y < sizes.rows; ++y) {
      for (int x = 0; x < sizes.cols; ++x) {
        if (sizes(y, x) > 0 && sizes(y, x) < p_.min_size) {
          filtered.invalidate(y, x, xgm::Status::peak);
        }
      }
    }
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
