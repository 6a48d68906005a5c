// SPDX-License-Identifier: Apache-2.0
// Every plugin of the library keeps the contract of its kind.
#include <map>
#include <set>

#include "external/programs.hpp"
#include "support/support.hpp"
#include "xgm/testing/contract.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Plugins that need more than their name, because a stage inside has no default.
const std::map<std::string, std::string>& configurations() {
  static const std::string semi_global =
      "{type: semi_global, cost: census, penalty: constant, aggregation: sgm}";
  static const std::map<std::string, std::string> table{
      {"cost/weighted_sum",
       "{type: weighted_sum, costs: [census, absolute_difference], weights: [1, 1]}"},
      {"cost/external", "{type: external, " + honest("cost") + "}"},
      {"filter/external", "{type: external, " + honest("filter") + "}"},
      {"matcher/external", "{type: external, range_maps: true, " + honest("match") + "}"},
      {"confidence/weighted",
       "{type: weighted, confidences: [curvature, left_right_difference, so_far], weights: [1, 2, "
       "1]}"},
      {"filter/confidence_threshold", "{type: confidence_threshold, min: 0.5}"},
      {"dataset/folder", "{type: folder, left: '{scene}/l.png', right: '{scene}/r.png'}"},
      {"fuser/forest", "{type: forest, costs: [{type: census, window: 5}, absolute_difference]}"},
      {"fuser/forest_samples", "{type: forest_samples, costs: [census]}"},
      {"matcher/semi_global", semi_global},
      {"matcher/filtered",
       "{type: filtered, filters: [{type: median}], matcher: " + semi_global + "}"},
      {"matcher/fusion", "{type: fusion, matchers: [" + semi_global +
                             ", {type: left_right, matcher: " + semi_global + "}]}"},
      {"matcher/left_right", "{type: left_right, matcher: " + semi_global + "}"},
      {"matcher/pyramid",
       "{type: pyramid, scale: 4, search_range: min_max, matcher: {type: "
       "left_right, matcher: " +
           semi_global + "}}"},
  };
  return table;
}

/// Plugins whose results are files made for certain images: there are none for those of the checks.
/// With sanitizers also those that start a program hundreds of times, which takes many minutes
/// then.
const std::set<std::string>& unchecked() {
  static const std::set<std::string> names{
      "cost/precomputed", "matcher/precomputed",
#ifdef XGM_SANITIZED
      "cost/external",    "filter/external",     "matcher/external",
#endif
  };
  return names;
}

std::string configuration(const PluginInfo& plugin) {
  const auto found = configurations().find(plugin.kind + "/" + plugin.name);
  return found == configurations().end() ? "{type: " + plugin.name + "}" : found->second;
}

void check(const PluginInfo& plugin) {
  INFO("plugin ", plugin.kind, "/", plugin.name);
  std::shared_ptr<const Stage> stage;
  try {
    stage = make_stage(plugin.kind, configuration(plugin), builtins());
  } catch (const Error& error) {
    FAIL_CHECK(
        "cannot be made, so its contract is not tested; give it a line in configurations(): ",
        error.what());
    return;
  }
  for (const std::string& violation : check_stage(*stage)) FAIL_CHECK(violation);
}

void check_all(const std::string& kind) {
  const auto plugins = builtins().plugins(kind);
  CHECK_MESSAGE(!plugins.empty(), "there is no plugin of kind ", kind);
  for (const PluginInfo* plugin : plugins) {
    if (!unchecked().contains(plugin->kind + "/" + plugin->name)) check(*plugin);
  }
}

}  // namespace

TEST_CASE("contract: every preprocess plugin") { check_all("preprocess"); }
TEST_CASE("contract: every matcher plugin") { check_all("matcher"); }
TEST_CASE("contract: every cost plugin") { check_all("cost"); }
TEST_CASE("contract: every penalty plugin") { check_all("penalty"); }
TEST_CASE("contract: every aggregation plugin") { check_all("aggregation"); }
TEST_CASE("contract: every selection plugin") { check_all("selection"); }
TEST_CASE("contract: every refinement plugin") { check_all("refinement"); }
TEST_CASE("contract: every filter plugin") { check_all("filter"); }
TEST_CASE("contract: every fuser plugin") { check_all("fuser"); }
TEST_CASE("contract: every consistency plugin") { check_all("consistency"); }
TEST_CASE("contract: every confidence plugin") { check_all("confidence"); }
TEST_CASE("contract: every dataset plugin") { check_all("dataset"); }
TEST_CASE("contract: every search_range plugin") { check_all("search_range"); }

TEST_CASE("contract: no kind is left out") { CHECK(builtins().kinds().size() == 14); }

TEST_CASE("contract: every line of the table is about a plugin that is there") {
  for (const auto& line : configurations()) {
    const std::string& plugin = line.first;
    const auto slash = plugin.find('/');
    CHECK_MESSAGE(builtins().find(plugin.substr(0, slash), plugin.substr(slash + 1)) != nullptr,
                  plugin);
  }
}
