// SPDX-License-Identifier: Apache-2.0
// Family of pipelines "my_plugin": files of "type: my_plugin" hold a matcher and nothing else.
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::StereoFamily {
 public:
  struct Parameters {
    xgm::Slot<xgm::Matcher> matcher;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matcher", p.matcher, "Finds the disparity map.").default_stage("opencv_sgbm");
  }
  explicit MyPlugin(Parameters p) : matcher_(std::move(p.matcher)) {}

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    return matcher_(context, request);
  }
  std::optional<xgm::Interval> disparities() const override { return xgm::Interval{0, 64}; }
  bool accepts_range_maps() const override { return matcher_->accepts_range_maps(); }

 private:
  xgm::Slot<xgm::Matcher> matcher_;
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<MyPlugin>("my_plugin", "Holds a matcher and nothing else."); }
