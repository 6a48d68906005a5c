// SPDX-License-Identifier: Apache-2.0
// The top of a stereo pipeline's file: preprocess, matcher, postprocess.
#include "plugins/pipeline/stereo/found_on_whole.hpp"
#include "plugins/pipeline/stereo/prepared_parts.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/plugin.hpp"
#include "xgm/stage/kept_results.hpp"

namespace {

// Widest bound of disparities that a file may ask for; keeps sums of bounds within an int.
constexpr double kMaxDisparity = 1e6;

class Stereo final : public xgm::StereoFamily {
 public:
  enum class Views { both, left };
  struct Parameters {
    std::vector<double> disparities;
    xgm::SlotList<xgm::Preprocess> preprocess;
    xgm::Slot<xgm::Matcher> matcher;
    xgm::SlotList<xgm::Filter> postprocess;
    Views views = Views::both;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("disparities", p.disparities,
            "Search range [first, last], both included, when neither the command line nor the "
            "scene gives one.")
        .unit("px")
        .range(-kMaxDisparity, kMaxDisparity)
        .whole()
        .elements({0, 2});
    set.add("preprocess", p.preprocess, "What is done to the images before matching, in order.");
    set.add("matcher", p.matcher, "Finds the disparity map.");
    set.add("postprocess", p.postprocess, "What is done to the finished maps, in order.");
    set.add_choice(
        "views", p.views,
        "Whose maps are finished: those of both views, as far as the matcher gives them, "
        "or the left one's alone, which saves the time that 'postprocess' takes for the "
        "right one. Files of results hold the left map.",
        {{"both", Views::both}, {"left", Views::left}});
    set.rule({"disparities"}, "must not begin above their end",
             [&p] { return p.disparities.empty() || p.disparities[0] <= p.disparities[1]; });
    set.rule({"postprocess", "matcher"},
             "holds one that needs a confidence, which the maps do not have; give the matcher one "
             "(confidence of semi_global or left_right)",
             [&p] {
               return p.matcher->gives_confidence() || !xgm::any_needs_confidence(p.postprocess);
             });
  }

  explicit Stereo(Parameters parameters) : stages_(std::move(parameters)) {}

  std::optional<xgm::Interval> disparities() const override {
    const auto& d = stages_.disparities;
    if (d.empty()) return std::nullopt;
    return xgm::Interval{static_cast<int>(d[0]), static_cast<int>(d[1]) + 1};
  }

  bool accepts_range_maps() const override { return stages_.matcher->accepts_range_maps(); }
  bool gives_confidence() const override { return stages_.matcher->gives_confidence(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    xgm::MatchRequest prepared = request;
    if (!request.part) prepared.pair = preprocess(request.pair, context.part(0, 0.03));
    xgm::MatchResult result = match(prepared, context.part(0.03, 0.95));
    if (request.part && request.part->scale > 1) return result;
    if (stages_.views == Views::left) result.reverse.reset();
    const xgm::Context rest = context.part(0.95, 1);
    for (const auto& stage : stages_.postprocess) {
      result.forward = stage(rest, result.forward, prepared.pair);
      if (!result.reverse) continue;
      result.reverse = stage(rest.other_view(), *result.reverse, prepared.pair.swapped());
    }
    return result;
  }

  int coarsest_scale() const override { return stages_.matcher->coarsest_scale(); }

  std::shared_ptr<const xgm::PairWindows> prepared(std::shared_ptr<const xgm::PairWindows> scene,
                                                   const xgm::Context& context) const override {
    const xgm::Context here = context.scope("preprocess");
    return prepare(std::move(scene), [&](const Stage& stage, const xgm::PairWindows& so_far) {
      return stage->fitted(so_far, here);
    });
  }

  bool looks_at_whole() const override { return !stages_.preprocess.empty(); }

  std::string found_on_whole(std::shared_ptr<const xgm::PairWindows> scene,
                             const xgm::Context& context) const override {
    const xgm::Context here = context.scope("preprocess");
    xgm::Json found = xgm::Json::array();
    prepare(std::move(scene), [&](const Stage& stage, const xgm::PairWindows& so_far) {
      auto fitted = stage->fitted(so_far, here);
      found.push_back(xgm::stereo::record_of(stage.plugin(), fitted.get(), here));
      return fitted;
    });
    return found.dump();
  }

  std::shared_ptr<const xgm::PairWindows> prepared_with(
      const std::string& text, std::shared_ptr<const xgm::PairWindows> scene,
      const xgm::Context& context) const override {
    const xgm::Context here = context.scope("preprocess");
    const xgm::Json found = xgm::Json::parse(text);
    auto record = found.begin();
    return prepare(std::move(scene), [&](const Stage& stage, const xgm::PairWindows& so_far) {
      if (record == found.end()) throw xgm::Error("nothing was found for '" + stage.plugin() + "'");
      return xgm::stereo::fitted_by(*record++, stage.plugin(), stage.stage(), so_far, here);
    });
  }

 private:
  using Stage = xgm::Slot<xgm::Preprocess>;

  /// Key points leave hundreds of MB in the heap, also if the run is cancelled meanwhile.
  struct HeapTrimmed {
    ~HeapTrimmed() { xgm::trim_heap(); }
  };

  /// `fit` gives what a stage has found on the scene as the stages before leave it.
  template <class Fit>
  std::shared_ptr<const xgm::PairWindows> prepare(std::shared_ptr<const xgm::PairWindows> scene,
                                                  Fit fit) const {
    const HeapTrimmed trimmed;
    for (const Stage& stage : stages_.preprocess) {
      auto fitted = fit(stage, *scene);
      scene = xgm::stereo::prepared(std::move(scene), stage.stage(), std::move(fitted));
    }
    return scene;
  }

  xgm::ImagePair preprocess(xgm::ImagePair pair, const xgm::Context& context) const {
    if (stages_.preprocess.empty()) return pair;
    const HeapTrimmed trimmed;
    for (const auto& stage : stages_.preprocess) pair = stage(context, pair);
    return pair;
  }

  /// A function of its own so that what volumes leave for each other is gone before the maps are
  /// worked on.
  xgm::MatchResult match(const xgm::MatchRequest& request, const xgm::Context& context) const {
    const xgm::BufferReuse reuse;
    xgm::KeptResults* const kept = xgm::kept_results();
    if (kept == nullptr) return stages_.matcher(context, request);
    const int scale = request.part ? request.part->scale : 1;
    const std::string name = scale > 1 ? "matcher, scale " + std::to_string(scale) : "matcher";
    if (std::optional<xgm::MatchResult> found = kept->find(name)) return std::move(*found);
    xgm::MatchResult result = stages_.matcher(context, request);
    kept->keep(name, result);
    return result;
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Stereo>("stereo",
                       "Matches one image pair: preprocess, matcher, postprocess. What a file "
                       "without 'type' is.");
}
