// SPDX-License-Identifier: Apache-2.0
// Several matchers on one pair, and one map of all of theirs.
#include <algorithm>
#include <string>

#include "xgm/plugin.hpp"
#include "xgm/stage/asked_once.hpp"

namespace {

/// The matchers run one after the other, each with all threads, so that the memory is that of the
/// largest and the maps of all. Equal ones, also inside others, run once if they are asked the
/// same. The reverse view is fused if every matcher gives a map of it.
class Fusion final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::SlotList<xgm::Matcher> matchers;
    xgm::Slot<xgm::Fuser> fuser;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matchers", p.matchers, "Each matches the pair.");
    set.add("fuser", p.fuser, "Picks one of their disparities for each pixel.")
        .default_stage("median");
    set.rule({"matchers"}, "must have at least one matcher", [&p] { return !p.matchers.empty(); });
    set.rule({"matchers", "fuser"}, "must be as many as the fuser was made for", [&p] {
      const int wanted = p.fuser->matchers();
      return wanted == 0 || p.matchers.size() == static_cast<std::size_t>(wanted);
    });
  }

  explicit Fusion(Parameters parameters) : stages_(std::move(parameters)) {}

  bool accepts_range_maps() const override {
    return all_matchers([](const xgm::Matcher& m) { return m.accepts_range_maps(); });
  }
  bool gives_reverse_map() const override {
    return all_matchers([](const xgm::Matcher& m) { return m.gives_reverse_map(); });
  }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    const xgm::MatchRequest whole{request.pair, request.range, request.reverse_range};
    xgm::AskedOnce once(whole, stages_.matchers);
    xgm::Candidates found;
    double share = 0;
    const double step = 0.96 / static_cast<double>(stages_.matchers.size());
    for (const auto& matcher : stages_.matchers) {
      xgm::MatchResult result = once.ask(matcher, context.part(share, share + step));
      found.maps.push_back(std::move(result.forward));
      found.others.push_back(std::move(result.reverse).value_or(xgm::DisparityMap{}));
      share += step;
    }
    xgm::MatchResult fused;
    fused.forward = stages_.fuser(context.part(0.96, 0.98), found, request.pair);
    if (gives_reverse_map()) {
      std::swap(found.maps, found.others);
      fused.reverse =
          stages_.fuser(context.part(0.98, 1).other_view(), found, request.pair.swapped());
    }
    return fused;
  }

 private:
  template <class Says>
  bool all_matchers(const Says& says) const {
    return std::all_of(stages_.matchers.begin(), stages_.matchers.end(),
                       [&](const auto& matcher) { return says(matcher.stage()); });
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Fusion>("fusion",
                       "Runs several matchers and picks among their disparities, pixel by pixel.");
}
