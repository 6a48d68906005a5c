// SPDX-License-Identifier: Apache-2.0
// Matcher "upside_down": lets another matcher match the pair turned upside down. A matcher that
// prefers no direction gives the same map as without.
#include <xgm/plugin.hpp>

namespace {

template <class Mat>
Mat flipped(const Mat& mat) {
  Mat result;
  if (!mat.empty()) cv::flip(mat, result, 0);
  return result;
}

xgm::Image flipped(const xgm::Image& image) {
  xgm::Image result;
  for (const cv::Mat1f& plane : image.planes) result.planes.push_back(flipped(plane));
  result.valid = flipped(image.valid);
  return result;
}

xgm::DisparityRange flipped(const xgm::DisparityRange& range) {
  if (range.is_uniform()) return range;
  const int height = range.size().height;
  return xgm::DisparityRange::of_pixels(range.size(),
                                        [&](int y, int x) { return range.at(height - 1 - y, x); });
}

void flip(xgm::DisparityMap& map) {
  map.disparity = flipped(map.disparity);
  map.status = flipped(map.status);
}

class UpsideDown final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::Slot<xgm::Matcher> matcher;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matcher", p.matcher, "Matches the pair that stands on its head.");
  }
  explicit UpsideDown(Parameters p) : matcher_(std::move(p.matcher)) {}

  bool accepts_range_maps() const override { return matcher_->accepts_range_maps(); }
  bool gives_reverse_map() const override { return matcher_->gives_reverse_map(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    const xgm::ImagePair& pair = request.pair;
    xgm::MatchRequest turned{{flipped(pair.base), flipped(pair.match), pair.is_reverse},
                             flipped(request.range),
                             std::nullopt};
    if (request.reverse_range) turned.reverse_range = flipped(*request.reverse_range);
    xgm::MatchResult result = matcher_(context, turned);
    flip(result.forward);
    if (result.reverse) flip(*result.reverse);
    return result;
  }

 private:
  xgm::Slot<xgm::Matcher> matcher_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<UpsideDown>("upside_down", "Lets another matcher match the pair upside down.");
}
