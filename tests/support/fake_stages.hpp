// SPDX-License-Identifier: Apache-2.0
// Small stages for tests of the framework, and a registry that holds them.
#pragma once

#include "xgm/plugin.hpp"

namespace xgm::testing {

enum class Shade { light, dark };

/// A cost with one parameter of each type.
class FakeCost final : public Cost {
 public:
  struct Parameters {
    int window = 5;
    double sigma = 1.5;
    bool clamp = true;
    Shade shade = Shade::light;
    std::vector<double> weights{1, 2};
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("window", p.window, "Side of the window.").unit("px").range(3, 9).odd();
    set.add("sigma", p.sigma, "Width of the bell.").unit("grey levels").range(0.1, 100);
    set.add("clamp", p.clamp, "Whether to clamp.");
    set.add_choice("shade", p.shade, "Which shade.",
                   {{"light", Shade::light}, {"dark", Shade::dark}});
    set.add("weights", p.weights, "Two weights.").range(0, 10);
    set.rule({"weights"}, "must be two numbers", [&p] { return p.weights.size() == 2; });
  }
  explicit FakeCost(Parameters p) : parameters(std::move(p)) {}
  CostVolume run(const ImagePair&, const VolumeShapePtr& shape, const Context&) const override {
    CostVolume costs(shape, 0);
    std::fill_n(costs.data(), costs.bytes(), std::uint8_t{0});
    return costs;
  }
  Parameters parameters;
};

/// A penalty with a rule between two parameters.
class FakePenalty final : public Penalty {
 public:
  struct Parameters {
    int p1 = 8;
    int p2 = 32;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("p1", p.p1, "Small step.").unit("cost").range(0, 3000);
    set.add("p2", p.p2, "Large step.").unit("cost").range(0, 3000);
    set.rule({"p2", "p1"}, "must not be below p1", [&p] { return p.p2 >= p.p1; });
  }
  explicit FakePenalty(Parameters) {}
  std::unique_ptr<const PenaltyField> run(const ImagePair&, const Context&) const override {
    return nullptr;
  }
};

/// A filter without parameters, which passes maps through, or throws when it is called "failing".
template <bool kFails>
class FakeFilter final : public Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit FakeFilter(Parameters) {}
  DisparityMap run(const DisparityMap& map, const ImagePair&, const Context&) const override {
    if (kFails) throw Error("cannot go on; do something else");
    return map;
  }
};

/// A matcher that answers the lower end of the range everywhere; holds a cost, a penalty, a matcher
/// (optional) and filters.
class FakeMatcher final : public Matcher {
 public:
  struct Parameters {
    Slot<Cost> cost;
    Slot<Penalty> penalty;
    Slot<Matcher> matcher;
    SlotList<Filter> filters;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("cost", p.cost, "The cost.");
    set.add("penalty", p.penalty, "The penalty.").default_stage("fake_penalty");
    set.add("matcher", p.matcher, "A matcher inside.").optional();
    set.add("filters", p.filters, "Filters.");
  }
  explicit FakeMatcher(Parameters p) : p_(std::move(p)) {}
  MatchResult run(const MatchRequest& request, const Context& context) const override {
    DisparityMap map(request.pair.size());
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        map.set(y, x, static_cast<float>(request.range.at(y, x).begin));
      }
    }
    for (const auto& filter : p_.filters) map = filter(context, map, request.pair);
    return {map, std::nullopt};
  }
  bool accepts_range_maps() const override { return false; }

 private:
  Parameters p_;
};

inline Registry fake_registry() {
  Registry registry;
  registry.add<FakeCost>("fake_cost", "A cost for tests");
  registry.add<FakePenalty>("fake_penalty", "A penalty for tests");
  registry.add<FakeFilter<false>>("fake_filter", "A filter for tests", "Nobody, Nowhere 2000");
  registry.add<FakeFilter<true>>("failing_filter", "A filter that fails");
  registry.add<FakeMatcher>("fake_matcher", "A matcher for tests");
  static const Registry builtins = Registry::with_builtins();
  registry.add(*builtins.find("pipeline", "stereo"));
  return registry;
}

}  // namespace xgm::testing
