// SPDX-License-Identifier: Apache-2.0
// Every stage inside composed matchers is told which view it works on.
#include "support/support.hpp"

using namespace xgm;

namespace {

/// Passes maps through and remembers which views it was called for.
class ViewRecorder final : public Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit ViewRecorder(Parameters) {}
  DisparityMap run(const DisparityMap& map, const ImagePair& pair, const Context&) const override {
    views.push_back(pair.is_reverse);
    return map;
  }
  static inline std::vector<bool> views;
};

}  // namespace

TEST_CASE("filters inside pyramid(left_right(semi_global)) know the reverse view at every level") {
  Registry registry = Registry::with_builtins();
  registry.add<ViewRecorder>("view_recorder", "Remembers views.");
  const auto matcher = make_stage<Matcher>(
      "{type: pyramid, scale: 4, matcher: {type: left_right, matcher: {type: semi_global, cost: "
      "census, penalty: constant, aggregation: sgm, filters: [view_recorder]}}}",
      registry);
  ViewRecorder::views.clear();
  const ImagePair pair = xgm::testing::shifted_pair({40, 30}, 3, 1);
  const auto range = DisparityRange::uniform(pair.size(), {0, 8});
  matcher->run({pair, range, std::nullopt}, Context{});
  CHECK(ViewRecorder::views == std::vector<bool>{false, true, false, true, false, true});
  matcher->run({pair.swapped(), range.reversed(), std::nullopt}, Context{});
  CHECK(ViewRecorder::views == std::vector<bool>{false, true, false, true, false, true, true, false,
                                                 true, false, true, false});
}
