// SPDX-License-Identifier: Apache-2.0
// Cost "absolute_difference": mean over the channels of |I_b(p) - I_m(p - d)|, truncated.
#include <algorithm>

#include "plugins/cost/absolute_difference/difference.hpp"
#include "plugins/cost/candidate_costs/truncated_mean.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace kernel = xgm::absolute_difference;

class AbsoluteDifference final : public xgm::Cost {
 public:
  using Parameters = xgm::cost::Truncation;
  static void describe(Parameters& p, xgm::ParameterSet& set) { Parameters::describe(p, set); }

  explicit AbsoluteDifference(const Parameters& p) : truncation_(p.truncation) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const auto compare = [&](const xgm::cost::RowPair<float>& rows, int y, xgm::CostVolume& costs) {
      kernel::compare(rows, y, static_cast<float>(truncation_), costs);
    };
    return xgm::cost::compare_rows(images, shape, truncation_, kernel::levels, compare);
  }

 private:
  int truncation_;
};

}  // namespace

xgm::cost::PixelRow<float> xgm::absolute_difference::levels(const Image& image, int y,
                                                            const cost::RowLayout& layout) {
  cost::PixelRow<float> row(image, y, static_cast<int>(image.planes.size()), layout);
  int k = 0;
  for (const cv::Mat1f& plane : image.planes) {
    float* const levels = row.plane(k++);
    std::copy_n(plane[y], plane.cols, levels);
    if (layout.mirrored) std::reverse(levels, levels + plane.cols);
  }
  return row;
}

XGM_PLUGIN(registry) {
  registry.add<AbsoluteDifference>(
      "absolute_difference", "Absolute difference of grey levels, mean over channels, truncated.",
      "Scharstein & Szeliski, A taxonomy and evaluation of dense two-frame stereo correspondence "
      "algorithms, IJCV 2002");
}
