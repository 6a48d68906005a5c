// SPDX-License-Identifier: Apache-2.0
// Fills holes with the planes of the segments around them. Which plane is chosen by what the other
// image shows there, by what may be hidden, and so that neighbours of one colour agree.
#include <algorithm>
#include <cmath>

#include "plugins/filter/plane_filling/candidate_costs.hpp"
#include "plugins/filter/plane_filling/choice.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace pf = xgm::plane_filling;
using xgm::DisparityMap;
using xgm::Status;

class PlaneFilling final : public xgm::Filter, public xgm::StatesNeeds {
 public:
  enum class Background { lowest, highest };
  struct Parameters {
    double scale = 100;
    int min_size = 30;
    double jump = 1.5;
    double outliers = 0;
    double sigma_range = 10;
    double occlusion = 0.35;
    double hides = 0.6;
    double path = 0.02;
    double smoothness = 0.3;
    double edge = 1;
    Background background = Background::lowest;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    describe_segments(p, set);
    describe_choice(p, set);
  }
  explicit PlaneFilling(Parameters p) : p_(p) {}

  DisparityMap run(const DisparityMap& map, const xgm::ImagePair& pair,
                   const xgm::Context& context) const override {
    const pf::Segments segments =
        pf::find_segments(map, pair.base, {p_.scale, p_.min_size, p_.jump});
    const std::vector<std::optional<pf::Plane>> planes = pf::fit_planes(map, segments);
    DisparityMap filled = map.clone();
    if (p_.outliers > 0) remove_outliers(segments, planes, filled);
    const pf::Holes holes = pf::find_holes(filled, pair.base);
    const pf::CandidateLists candidates =
        pf::find_candidates(holes, filled, map.disparity, segments, planes);
    const std::vector<float> costs = costs_of(holes, candidates, filled, pair);
    const pf::Smoothness smoothness{static_cast<float>(p_.smoothness), static_cast<float>(p_.edge),
                                    static_cast<float>(p_.sigma_range)};
    const std::vector<std::size_t> chosen =
        pf::choose(holes, candidates, costs, filled, smoothness);
    for (std::size_t hole = 0; hole < chosen.size(); ++hole) {
      if (candidates.of(hole).empty()) continue;
      const cv::Point at = holes.at[hole];
      filled.set(at.y, at.x, candidates.of(hole)[chosen[hole]].disparity, Status::filled);
    }
    context.figure("segments", segments.count);
    return filled;
  }

  xgm::Needs needs(const xgm::Workload& load) const override {
    // Segments, census and grey levels of all pixels; what holes see, candidates and path costs of
    // a quarter of them, which is more than most maps have.
    constexpr double kPerPixel = 60, kPerPlane = 8, kPerHole = 8 * 12 + 9 * 36;
    return {.working = load.pixels() * (kPerPixel + load.planes * kPerPlane + kPerHole / 4),
            .updates = load.pixels()};
  }

 private:
  static void describe_segments(Parameters& p, xgm::ParameterSet& set) {
    set.add("scale", p.scale,
            "Size of the segments: neighbours are joined that differ by at most scale / size more "
            "than those in the segments do.")
        .unit("grey levels x px")
        .range(0, 1e6);
    set.add("min_size", p.min_size,
            "Smaller segments are joined with the neighbour that is most like them.")
        .unit("px")
        .range(1, 1e9);
    set.add("jump", p.jump, "Neighbours whose disparities differ by more are not joined directly.")
        .unit("px")
        .range(0, 1e6);
    set.add(
           "outliers", p.outliers,
           "Pixels farther from the plane of their segment are filled like holes, unless what they "
           "have fits better than all else; 0: none are.")
        .unit("px")
        .range(0, 1e6);
  }
  static void describe_choice(Parameters& p, xgm::ParameterSet& set) {
    set.add("sigma_range", p.sigma_range,
            "Colour difference of neighbours at which their agreement has 1 / e of its weight.")
        .unit("grey levels")
        .range(0.1, 1000);
    set.add("occlusion", p.occlusion,
            "Matching cost of a pixel that the other image does not show: outside of it, or "
            "behind what was matched there. The cost is 0 where the images are the same, and 1 "
            "where they have nothing in common.")
        .range(0, 1);
    set.add("hides", p.hides, "Cost of a disparity that would hide what was matched.")
        .range(0, 1000);
    set.add("path", p.path,
            "Cost of a grey level of colour difference on the path to the pixel that offers the "
            "plane; no more than 60 levels count.")
        .range(0, 1000);
    set.add("smoothness", p.smoothness,
            "Cost of a difference between neighbours of one colour, per px.")
        .range(0, 1000);
    set.add("edge", p.edge, "The most that a difference between neighbours costs.").range(0, 1000);
    set.add_choice(
        "background", p.background,
        "Which disparities of the left map are the far ones: the lowest, or the highest where the "
        "images were given the other way round. In the right map it is the reverse, always.",
        {{"lowest", Background::lowest}, {"highest", Background::highest}});
  }

  void remove_outliers(const pf::Segments& segments,
                       const std::vector<std::optional<pf::Plane>>& planes,
                       DisparityMap& map) const {
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        const int label = segments.label(y, x);
        if (label < 0 || !map.has_disparity(y, x)) continue;
        const std::optional<pf::Plane>& plane = planes[static_cast<std::size_t>(label)];
        if (!plane || std::abs(plane->at(y, x) - map.disparity(y, x)) <= p_.outliers) continue;
        map.invalidate(y, x, Status::mismatched);
      }
    });
  }

  std::vector<float> costs_of(const pf::Holes& holes, const pf::CandidateLists& candidates,
                              const DisparityMap& map, const xgm::ImagePair& pair) const {
    const bool far_is_low = (p_.background == Background::lowest) != pair.is_reverse;
    const pf::CandidateCosts cost(map, pair,
                                  {static_cast<float>(p_.occlusion), static_cast<float>(p_.hides),
                                   static_cast<float>(p_.path), far_is_low});
    std::vector<float> costs(candidates.all.size());
    constexpr std::size_t kPart = 1024;  // holes
    const std::size_t parts = (holes.at.size() + kPart - 1) / kPart;
    xgm::parallel_for(0, static_cast<int>(parts), [&](int part) {
      const std::size_t begin = static_cast<std::size_t>(part) * kPart;
      const std::size_t end = std::min(holes.at.size(), begin + kPart);
      for (std::size_t hole = begin; hole < end; ++hole) {
        for (std::size_t i = candidates.begin[hole]; i < candidates.begin[hole + 1]; ++i) {
          costs[i] = cost.of(holes.at[hole], candidates.all[i]);
        }
      }
    });
    return costs;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<PlaneFilling>(
      "plane_filling",
      "Fills holes with the planes of the segments around them, chosen by the images; masked "
      "pixels stay empty.",
      "Yamaguchi, McAllester, Urtasun, Efficient joint segmentation, occlusion labeling, stereo "
      "and "
      "flow estimation, ECCV 2014; Bleyer and Gelautz, A layered stereo matching algorithm using "
      "image segmentation and global visibility constraints, ISPRS Journal 59(3), 2005; "
      "Felzenszwalb and Huttenlocher, Efficient graph-based image segmentation, IJCV 59(2), 2004");
}
