// SPDX-License-Identifier: Apache-2.0
// A pair cannot tell an error along its epipolar lines from height, but a DEM can: the point of a
// base pixel on the DEM should be seen by the match camera where the key point is. What it lies
// beside that, along the line and across it, is taken out in the median over all key points, which
// trees and buildings above the DEM, errors of its heights and wrong matches hardly move.
#include <cmath>

#include "plugins/pointing/pair_offsets/corrections.hpp"
#include "plugins/pointing/tie_points/search.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

/// What key points lie beside where the DEM says that they should be.
struct Deviations {
  std::vector<double> along, across;  ///< px
  cv::Vec2d direction, normal;        ///< of length 1, in the match image
  cv::Point2d here;                   ///< one of the pixels of the base image
  double height = 0;                  ///< of its ground, m
  double per_metre = 0;               ///< px along the line
};

Deviations deviations_of(const SatelliteImage& base, const SatelliteImage& match,
                         const std::vector<KeypointMatch>& matches, const HeightField& dem) {
  Deviations result;
  for (const KeypointMatch& m : matches) {
    const auto point = base.camera.localize(m.base, dem);
    if (!point) continue;
    constexpr double kRise = 10;  // m
    const auto higher = base.camera.localize(m.base, point->height + kRise);
    if (!higher) continue;
    const cv::Point2d should = match.camera.project(*point);
    const cv::Point2d line = match.camera.project(*higher) - should;
    const double length = cv::norm(line);
    if (!(length > 1e-3)) continue;
    const cv::Vec2d direction(line.x / length, line.y / length);
    const cv::Vec2d normal(-direction[1], direction[0]);
    const cv::Vec2d beside(m.match.x - should.x, m.match.y - should.y);
    result.along.push_back(beside.dot(direction));
    result.across.push_back(beside.dot(normal));
    result.direction += direction;
    result.normal += normal;
    result.here = m.base;
    result.height = point->height;
    result.per_metre = length / kRise;
  }
  if (!result.along.empty()) {
    result.direction /= cv::norm(result.direction);
    result.normal /= cv::norm(result.normal);
  }
  return result;
}

class AlignToDem final : public Pointing {
 public:
  struct Parameters {
    TieSearch search;
    int min_matches = 50;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    geo::describe(p.search, set);
    set.add("min_matches", p.min_matches,
            "With fewer matches on the DEM the cameras of a pair are left as they are, with a "
            "warning.")
        .range(3, 100000);
  }

  explicit AlignToDem(Parameters parameters) : p_(parameters) {}

  bool needs_dem() const override { return true; }

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>& pairs,
                                  const GroundKnowledge& ground,
                                  const Context& context) const override {
    if (ground.dem == nullptr) {
      throw Error("pointing align_to_dem needs a DEM; give one, or use pointing keypoints");
    }
    std::vector<PairOffset> offsets;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const SatelliteImage& base = images[pairs[i].base];
      const SatelliteImage& match = images[pairs[i].match];
      const Deviations found = deviations_of(
          base, match, find_ties(base, match, ground.heights, p_.search), *ground.dem);
      const std::string what = base.name + " " + match.name;
      context.figure(what + " matches", static_cast<double>(found.along.size()));
      if (found.along.size() < static_cast<std::size_t>(p_.min_matches)) {
        context.warn(what + ": only " + std::to_string(found.along.size()) +
                     " key points match on the DEM; their cameras are used as they are");
        continue;
      }
      offsets.push_back(
          pair_offset(images, pairs[i], found.normal, found.across, found.here, found.height));
      context.figure(what + " across_px", offsets.back().offset);
      offsets.push_back(
          pair_offset(images, pairs[i], found.direction, found.along, found.here, found.height));
      context.figure(what + " along_px", offsets.back().offset);
      context.figure(what + " height_m", offsets.back().offset / found.per_metre);
      context.progress(static_cast<double>(i + 1) / static_cast<double>(pairs.size()));
    }
    return without(offsets, images);
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<AlignToDem>("align_to_dem",
                           "Corrects each pair by key points, across its epipolar lines and, "
                           "against a DEM, along them.");
}
