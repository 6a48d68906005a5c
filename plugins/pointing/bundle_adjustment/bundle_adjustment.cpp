// SPDX-License-Identifier: Apache-2.0
// All cameras at once: Grodecki, Dial: Block adjustment of high-resolution satellite images
// described by rational polynomials (PE&RS 69(1), 2003), with a shift per image, a0 and b0, alone;
// tie points are key points, with a robust loss.
#include "plugins/pointing/bundle_adjustment/adjust.hpp"
#include "plugins/pointing/tie_points/search.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class BundleAdjustment final : public Pointing {
 public:
  struct Parameters {
    TieSearch search;
    int min_points = 10;
    AdjustmentSettings settings;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    geo::describe(p.search, set);
    set.add("min_points", p.min_points,
            "Images that show fewer tie points are named in a warning; little holds them.")
        .range(3, 100000);
    set.add("prior", p.settings.prior,
            "Standard deviation of the cameras' errors as the vendor states them. It decides what "
            "tie points cannot: of all solutions that fit them, that with the smallest shifts.")
        .unit("px")
        .range(0.01, 1000);
    set.add("loss", p.settings.loss,
            "Scale of Cauchy's loss: residuals above it count less and less.")
        .unit("px")
        .range(0.01, 100);
    set.add("keep_first", p.settings.keep_first,
            "Leave the first image where it is, as the datum of the others.");
  }

  explicit BundleAdjustment(Parameters parameters) : p_(parameters) {}

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>& pairs,
                                  const GroundKnowledge& ground,
                                  const Context& context) const override {
    std::vector<std::vector<KeypointMatch>> matches;
    for (const PairChoice& pair : pairs) {
      matches.push_back(
          find_ties(images[pair.base], images[pair.match], ground.heights, p_.search));
      context.progress(0.9 * static_cast<double>(matches.size()) /
                       static_cast<double>(pairs.size()));
    }
    const std::vector<Track> tracks = join_tracks(pairs, matches);
    std::vector<RpcCamera> cameras;
    for (const SatelliteImage& image : images) cameras.push_back(image.camera);
    const Adjustment found = adjust(cameras, tracks, p_.settings);
    report(images, tracks, found, context);
    std::vector<SatelliteImage> corrected = images;
    for (std::size_t i = 0; i < images.size(); ++i) {
      corrected[i].camera = images[i].camera.cropped(-found.biases[i]);
    }
    return corrected;
  }

 private:
  void report(const std::vector<SatelliteImage>& images, const std::vector<Track>& tracks,
              const Adjustment& found, const Context& context) const {
    std::vector<int> points(images.size());
    std::size_t in_many = 0;
    for (const Track& track : tracks) {
      in_many += track.size() > 2;
      for (const Observation& o : track) ++points[o.image];
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string& name = images[i].name;
      context.figure(name + " points", points[i]);
      context.figure(name + " column_px", found.biases[i].x);
      context.figure(name + " row_px", found.biases[i].y);
      if (points[i] < p_.min_points) {
        context.warn(name + ": only " + std::to_string(points[i]) +
                     " tie points hold its camera; give pairs that overlap it");
      }
    }
    context.figure("tie_points", static_cast<double>(found.tracks));
    context.figure("tie_points_in_more_than_two", static_cast<double>(in_many));
    context.figure("median_before_px", found.median_before);
    context.figure("median_after_px", found.median_after);
    context.figure("datum_east_m", found.datum[0]);
    context.figure("datum_north_m", found.datum[1]);
    context.figure("datum_up_m", found.datum[2]);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<BundleAdjustment>(
      "bundle_adjustment", "Corrects all cameras at once by tie points, a shift of each image.",
      "Grodecki, Dial: Block adjustment of high-resolution satellite images described by rational "
      "polynomials, PE&RS 69(1), 2003");
}
