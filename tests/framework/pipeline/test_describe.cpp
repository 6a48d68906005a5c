// SPDX-License-Identifier: Apache-2.0
// Help, schema and resolved configuration come from the one declaration.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/fake_stages.hpp"
#include "xgm/pipeline/describe.hpp"
#include "xgm/pipeline/pipeline.hpp"

using namespace xgm;
using nlohmann::json;

TEST_CASE("describe shows every parameter with default, range, unit and rules") {
  const Registry registry = xgm::testing::fake_registry();
  const json cost = json::parse(describe_json(*registry.find("cost", "fake_cost")));
  REQUIRE(cost["parameters"].size() == 5);
  CHECK(cost["parameters"][0] == json{{"name", "window"},
                                      {"text", "Side of the window."},
                                      {"expected", "an odd whole number from 3 to 9"},
                                      {"unit", "px"},
                                      {"range", {3, 9}},
                                      {"odd", true},
                                      {"default", 5}});
  CHECK(cost["parameters"][3]["choices"] == json{"light", "dark"});
  CHECK(cost["rules"] == json{"weights must be two numbers."});
  const std::string text = describe_text(*registry.find("matcher", "fake_matcher"));
  for (const std::string part :
       {"cost = required", "penalty = fake_penalty", "matcher = none", "filters = none"}) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, part);
  }
  CHECK(describe_markdown(*registry.find("filter", "fake_filter")).find("Nobody, Nowhere 2000") !=
        std::string::npos);
}

TEST_CASE("the resolved configuration is itself a pipeline that resolves to the same") {
  const Registry registry = xgm::testing::fake_registry();
  const auto first = load_pipeline_text(
      "matcher: {type: fake_matcher, cost: fake_cost, filters: [fake_filter]}", "a", registry);
  REQUIRE(first.pipeline.has_value());
  const std::string resolved = first.pipeline->resolved_json();
  const auto second = load_pipeline_text(resolved, "b", registry);
  for (const Diagnostic& d : second.diagnostics) MESSAGE(to_string(d));
  REQUIRE(second.pipeline.has_value());
  CHECK(second.pipeline->resolved_json() == resolved);
  CHECK(first.pipeline->graph().find("cost: fake_cost  (window=5") != std::string::npos);
}

TEST_CASE("the schema names every plugin, parameter and bound") {
  const Registry registry = xgm::testing::fake_registry();
  const json schema = json::parse(pipeline_schema(registry));
  CHECK(schema["required"] == json{"matcher"});
  const json& cost = schema["definitions"]["cost"]["anyOf"];
  REQUIRE(cost.size() == 2);
  CHECK(cost[0]["enum"] == json{"fake_cost"});
  CHECK(cost[1]["properties"]["window"]["maximum"] == 9);
  CHECK(cost[1]["additionalProperties"] == false);
  const json& matcher = schema["definitions"]["matcher"]["anyOf"];
  REQUIRE(matcher.size() == 1);  // no bare name: it needs a cost
  CHECK(matcher[0]["required"] == json{"type", "cost"});
}
