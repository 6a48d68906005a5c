// SPDX-License-Identifier: Apache-2.0
// A pyramid of its own making, and a kind of stage of its own: matcher "two_scales" matches at a
// third of the size, and then around what was found there. How the coarse map becomes a fine one is
// left to a stage of kind "upsampling".
#include <algorithm>
#include <xgm/plugin.hpp>

namespace {

constexpr int kScale = 3;

int divided(int n) { return (n + kScale - 1) / kScale; }

class Upsampling : public xgm::Stage {
 public:
  static constexpr std::string_view kKind = "upsampling";
  static constexpr std::string_view kMeaning = "makes a map of a larger one's size";

  /// A map of `size`, three times as large as `coarse`, in its own pixels.
  virtual xgm::DisparityMap run(const xgm::DisparityMap& coarse, const cv::Size& size,
                                const xgm::Context& context) const = 0;
};

class Nearest final : public Upsampling {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit Nearest(Parameters) {}

  xgm::DisparityMap run(const xgm::DisparityMap& coarse, const cv::Size& size,
                        const xgm::Context&) const override {
    xgm::DisparityMap fine(size);
    xgm::parallel_for(0, size.height, [&](int y) {
      for (int x = 0; x < size.width; ++x) {
        const int v = y / kScale, u = x / kScale;
        if (coarse.has_disparity(v, u)) fine.set(y, x, kScale * coarse.disparity(v, u));
      }
    });
    return fine;
  }
};

/// Means of 3 x 3 pixels, fewer at the right and the lower edge.
xgm::Image reduced(const xgm::Image& image) {
  xgm::Image small;
  const cv::Size full = image.size(), size(divided(full.width), divided(full.height));
  for (const cv::Mat1f& plane : image.planes) {
    cv::Mat1f& means = small.planes.emplace_back(size);
    xgm::parallel_for(0, size.height, [&](int y) {
      for (int x = 0; x < size.width; ++x) {
        const cv::Rect block(kScale * x, kScale * y, kScale, kScale);
        means(y, x) = static_cast<float>(cv::mean(plane(block & cv::Rect({}, full)))[0]);
      }
    });
  }
  return small;
}

class TwoScales final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::Slot<xgm::Matcher> matcher;
    xgm::Slot<Upsampling> upsampling;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matcher", p.matcher, "Matches either scale.");
    set.add("upsampling", p.upsampling, "Makes a fine map of the coarse one.")
        .default_stage("nearest");
  }
  explicit TwoScales(Parameters p) : stages_(std::move(p)) {}

  bool gives_reverse_map() const override { return stages_.matcher->gives_reverse_map(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    const xgm::ImagePair& pair = request.pair;
    const xgm::Interval hull = request.range.hull();
    const xgm::ImagePair small{reduced(pair.base), reduced(pair.match), pair.is_reverse};
    const auto range = xgm::DisparityRange::uniform(
        small.size(), {hull.begin / kScale - 1, hull.end / kScale + 2});
    const xgm::MatchResult coarse = stages_.matcher(context.part(0, 0.1).level("thumbnail", kScale),
                                                    xgm::MatchRequest{small, range, {}});
    const xgm::DisparityMap prior =
        stages_.upsampling(context.part(0.1, 0.1), coarse.forward, pair.size());
    return stages_.matcher(context.part(0.1, 1).level("original", 1),
                           xgm::MatchRequest{pair, around(prior, request.range), {}});
  }

 private:
  /// Three pixels to either side of the coarse disparity; where there is none, everything.
  static xgm::DisparityRange around(const xgm::DisparityMap& prior,
                                    const xgm::DisparityRange& limits) {
    return xgm::DisparityRange::of_pixels(limits.size(), [&](int y, int x) {
      if (!prior.has_disparity(y, x)) return limits.at(y, x);
      const int d = static_cast<int>(prior.disparity(y, x));
      const xgm::Interval near = xgm::intersect({d - kScale, d + kScale + 1}, limits.at(y, x));
      return near.empty() ? limits.at(y, x) : near;
    });
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add_kind<Upsampling>();
  registry.add<Nearest>("nearest", "Takes the disparity of the coarse pixel around.");
  registry.add<TwoScales>("two_scales", "Matches at a third of the size, then around that.");
}
