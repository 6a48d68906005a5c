// SPDX-License-Identifier: Apache-2.0
// Key points of a pair should lie on each other's epipolar lines. What they lie beside them, in the
// median, is the pointing error of the pair across the lines, and is shared by the two cameras. An
// error along the lines cannot be told from height. De Franchis, Meinhardt-Llopis, Michel, Morel,
// Facciolo: An automatic and modular stereo pipeline for pushbroom images (ISPRS Annals 2014),
// Section 4.
#include "plugins/pointing/pair_offsets/corrections.hpp"
#include "plugins/pointing/tie_points/search.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Keypoints final : public Pointing {
 public:
  struct Parameters {
    TieSearch search;
    int min_matches = 10;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    geo::describe(p.search, set);
    set.add("min_matches", p.min_matches,
            "With fewer matches the cameras of a pair are left as they are, with a warning.")
        .range(3, 100000);
  }

  explicit Keypoints(Parameters parameters) : p_(parameters) {}

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>& pairs,
                                  const GroundKnowledge& ground,
                                  const Context& context) const override {
    std::vector<PairOffset> offsets;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const SatelliteImage& base = images[pairs[i].base];
      const SatelliteImage& match = images[pairs[i].match];
      const std::vector<KeypointMatch> matches = find_ties(base, match, ground.heights, p_.search);
      const std::string what = base.name + " " + match.name;
      context.figure(what + " matches", static_cast<double>(matches.size()));
      if (matches.size() < static_cast<std::size_t>(p_.min_matches)) {
        context.warn(what + ": only " + std::to_string(matches.size()) +
                     " key points match; their cameras are used as they are");
        continue;
      }
      offsets.push_back(across(images, pairs[i], matches, ground.heights));
      context.figure(what + " across_px", offsets.back().offset);
      context.progress(static_cast<double>(i + 1) / static_cast<double>(pairs.size()));
    }
    return without(offsets, images);
  }

 private:
  static PairOffset across(const std::vector<SatelliteImage>& images, const PairChoice& pair,
                           const std::vector<KeypointMatch>& matches,
                           const HeightInterval& heights) {
    std::vector<double> offsets;
    cv::Vec2d normal;
    for (const KeypointMatch& m : matches) {
      offsets.push_back(m.across);
      normal += m.normal;
    }
    normal /= cv::norm(normal);
    return pair_offset(images, pair, normal, std::move(offsets), matches[matches.size() / 2].base,
                       (heights.min + heights.max) / 2);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Keypoints>("keypoints",
                          "Corrects each pair across its epipolar lines, by key points.",
                          "De Franchis, Meinhardt-Llopis, Michel, Morel, Facciolo: An automatic "
                          "and modular stereo pipeline for pushbroom images, ISPRS Annals 2014");
}
