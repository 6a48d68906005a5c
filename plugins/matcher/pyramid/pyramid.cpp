// SPDX-License-Identifier: Apache-2.0
// Coarse to fine: the map of one level says where the next finer one has to search.
#include <algorithm>
#include <string>

#include "plugins/matcher/pyramid/keep_within.hpp"
#include "xgm/data/halve.hpp"
#include "xgm/plugin.hpp"
#include "xgm/stage/kept_results.hpp"

namespace {

/// The paper's Algorithms 3 and 4 around any matcher that takes a range per pixel: with
/// left_right(semi_global) inside, tSGM and tMGM. The coarsest level searches all of the request's
/// range (Table 1); each finer one what the search_range stage makes of the checked map before it.
/// One thing differs: the paper relaxes the user's interval itself by epsilon, which would yield
/// disparities that nobody asked for. Here no level leaves the interval, rounded to its scale.
class Pyramid final : public xgm::Matcher {
 public:
  struct Parameters {
    int scale = 8;
    xgm::Slot<xgm::SearchRange> search_range;
    xgm::Slot<xgm::Matcher> matcher;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("scale", p.scale,
            "How many times smaller than the images the coarsest level is; a power of two, 1 for a "
            "single level.")
        .one_of({1, 2, 4, 8, 16, 32, 64});
    set.add("search_range", p.search_range,
            "What the next finer level searches, given the map of the coarser one.")
        .default_stage("min_max");
    set.add("matcher", p.matcher, "Matches each level.");
    set.rule({"matcher", "scale"},
             "must take a range per pixel; one that needs one range for the whole image cannot "
             "work here",
             [&p] { return p.scale == 1 || p.matcher->accepts_range_maps(); });
  }

  explicit Pyramid(Parameters parameters) : parameters_(std::move(parameters)) {}

  bool accepts_range_maps() const override { return parameters_.matcher->accepts_range_maps(); }
  int coarsest_scale() const override { return parameters_.scale; }
  bool gives_reverse_map() const override { return parameters_.matcher->gives_reverse_map(); }
  bool gives_confidence() const override { return parameters_.matcher->gives_confidence(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    xgm::ScenePart part = request.part.value_or(xgm::ScenePart{});
    take_up_kept(part, context);
    const int coarsest = part.coarse ? part.coarse_scale / 2 : parameters_.scale;
    int scale = part.scale;
    std::vector<xgm::MatchRequest> levels{{request.pair, request.range, request.reverse_range}};
    for (; scale < coarsest; scale *= 2) levels.push_back(xgm::halve(levels.back()));
    if (part.coarse) narrow(levels.back(), *part.coarse, level(context, scale));
    xgm::MatchResult result = parameters_.matcher(level(context, scale), levels.back());
    while (scale > part.scale) {
      keep(result, level(context, scale));
      scale /= 2;
      levels.pop_back();
      const xgm::Context here = level(context, scale);
      narrow(levels.back(), result, here);
      result = parameters_.matcher(here, levels.back());
    }
    return result;
  }

 private:
  /// The run's results, as far as its levels have names in them: of the pipeline's own matcher.
  static xgm::KeptResults* kept_levels(const xgm::Context& context) {
    return context.place().depth == 0 ? xgm::kept_results() : nullptr;
  }

  /// Begins after the finest level that an earlier run has found.
  void take_up_kept(xgm::ScenePart& part, const xgm::Context& context) const {
    xgm::KeptResults* const kept = kept_levels(context);
    if (kept == nullptr) return;
    const int coarsest = part.coarse ? part.coarse_scale / 2 : parameters_.scale;
    for (int scale = 2 * part.scale; scale <= coarsest; scale *= 2) {
      std::optional<xgm::MatchResult> found = kept->find(level(context, scale).path());
      if (!found) continue;
      part.coarse = std::move(found);
      part.coarse_scale = scale;
      return;
    }
  }

  static void keep(const xgm::MatchResult& result, const xgm::Context& level) {
    xgm::KeptResults* const kept = kept_levels(level);
    if (kept != nullptr) kept->keep(level.path(), result);
  }

  /// Replaces the ranges of the finer `request`, its limits, by what is left to search.
  void narrow(xgm::MatchRequest& request, const xgm::MatchResult& coarse,
              const xgm::Context& context) const {
    if (coarse.reverse) {
      const xgm::DisparityRange limits =
          request.reverse_range ? *request.reverse_range : request.range.reversed();
      request.reverse_range = narrowed(limits, *coarse.reverse, context.other_view());
    }
    request.range = narrowed(request.range, coarse.forward, context);
  }

  xgm::DisparityRange narrowed(const xgm::DisparityRange& limits, const xgm::DisparityMap& coarse,
                               const xgm::Context& context) const {
    return xgm::pyramid::keep_within(limits,
                                     parameters_.search_range(context.part(0, 0), coarse, limits));
  }

  /// The context of one level. Each has four times the pixels of the one before, and about as many
  /// disparities per pixel.
  xgm::Context level(const xgm::Context& context, int scale) const {
    const double coarser = 1.0 / parameters_.scale;
    const auto done = [&](double s) { return 1 / (s * s) - coarser * coarser / 4; };
    return context.level("s" + std::to_string(scale), scale)
        .part(done(2.0 * scale) / done(1), done(scale) / done(1));
  }

  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Pyramid>(
      "pyramid",
      "Matches coarse to fine; each level searches around the disparities of the one before.",
      "S. Patil, T. Prakash, B. Comandur, A. Kak: A comparative evaluation of SGM variants "
      "(including a new variant, tMGM) for dense stereo matching, Algorithms 3 and 4; M. "
      "Rothermel, K. Wenzel, D. Fritsch, N. Haala: SURE: Photogrammetric surface reconstruction "
      "from imagery, LC3D Workshop, 2012.");
}
