// SPDX-License-Identifier: Apache-2.0
// Messages for faulty pipeline files: located, complete, with a remedy.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "support/fake_stages.hpp"
#include "xgm/pipeline/pipeline.hpp"

using namespace xgm;

namespace {

LoadedPipeline load(const std::string& text, const std::vector<Override>& overrides = {}) {
  static const Registry registry = xgm::testing::fake_registry();
  return load_pipeline_text(text, "test.yaml", registry, overrides);
}

// All messages of a faulty file, one per line.
std::string messages(const std::string& text, const std::vector<Override>& overrides = {}) {
  const LoadedPipeline loaded = load(text, overrides);
  CHECK(loaded.pipeline.has_value() == loaded.diagnostics.empty());
  std::string all;
  for (const Diagnostic& d : loaded.diagnostics) all += to_string(d) + "\n";
  return all;
}

void check_one(const std::string& text, const std::string& expected) {
  CHECK(messages(text) == expected + "\n");
}

}  // namespace

TEST_CASE("a plugin that is taken away leaves its name free, and pipelines with it as they are") {
  Registry registry = Registry::with_builtins();
  const LoadedPipeline loaded =
      load_pipeline_text("matcher: opencv_sgbm\npostprocess: [median]\n", "own.yaml", registry);
  REQUIRE(loaded.pipeline);
  const PluginInfo median = *registry.find("filter", "median");
  CHECK(registry.remove("filter", "median"));
  CHECK_FALSE(registry.remove("filter", "median"));
  CHECK(registry.find("filter", "median") == nullptr);
  CHECK(loaded.pipeline->resolved_json().find("median") != std::string::npos);
  CHECK_NOTHROW(registry.add(median));
}

TEST_CASE("a sound pipeline loads, with defaults and bare words") {
  CHECK(messages("xgm: 1\nmatcher: {type: fake_matcher, cost: fake_cost}\n") == "");
  CHECK(messages("matcher: {type: fake_matcher, cost: {type: fake_cost, window: 7, sigma: 2,"
                 " clamp: false, shade: dark, weights: [1, 2.5]}, filters: [fake_filter]}") == "");
  CHECK(messages("matcher: {type: fake_matcher, cost: fake_cost, matcher: ~, filters: }") == "");
}

TEST_CASE("seven mistakes give exactly seven located messages, in file order") {
  const std::string text =
      "xgm: 1\n"
      "matcher:\n"
      "  type: fake_matcher\n"
      "  cost: {type: fake_cost, windw: 5, sigma: wide, weights: [1, 11]}\n"
      "  penalty: {type: fake_penalty, p1: 20, p2: 10}\n"
      "  penalty: fake_penalty\n"
      "  matcher: fake_filter\n"
      "  filters:\n"
      "    - fake_fliter\n";
  CHECK(messages(text) ==
        "test.yaml:4:27: error: fake_cost has no parameter 'windw'; did you mean 'window'?\n"
        "test.yaml:4:44: error: 'sigma' must be a number from 0.1 to 100, not 'wide'; change the "
        "value\n"
        "test.yaml:4:63: error: 'weights' cannot be 11; give a list of numbers from 0 to 10\n"
        "test.yaml:5:45: error: 'p2' of fake_penalty must not be below p1\n"
        "test.yaml:6:3: error: key 'penalty' appears twice; keep one of them (the first stands in "
        "line 5)\n"
        "test.yaml:7:12: error: 'fake_filter' is a filter, not a matcher; put a matcher here: "
        "fake_matcher\n"
        "test.yaml:9:7: error: there is no filter called 'fake_fliter'; did you mean "
        "'fake_filter'?\n");
}

TEST_CASE("values are taken strictly") {
  const auto cost = [](const std::string& value) {
    return "matcher: {type: fake_matcher, cost: {type: fake_cost, " + value + "}}";
  };
  for (const std::string good : {"window: 9", "sigma: 1e1", "sigma: +2", "clamp: true"}) {
    CHECK_MESSAGE(messages(cost(good)) == "", good);
  }
  for (const std::string bad :
       {"window: 4", "window: 5.0", "window: '5'", "window: 99999999999999999999", "window: [5]",
        "window: ", "sigma: nan", "sigma: inf", "sigma: 1px", "clamp: 1", "clamp: yes",
        "shade: drak", "shade: {}", "weights: 1", "weights: [1, x]", "weights: []"}) {
    const LoadedPipeline loaded = load(cost(bad));
    CHECK_MESSAGE(loaded.diagnostics.size() == 1, bad);
    if (!loaded.diagnostics.empty()) CHECK(loaded.diagnostics[0].where.line == 1);
  }
}

TEST_CASE("what is missing or of the wrong shape is said") {
  check_one("matcher: {type: fake_matcher}",
            "test.yaml:1:10: error: fake_matcher needs 'cost'; add 'cost: NAME', NAME being one of "
            "fake_cost");
  check_one("xgm: 1",
            "test.yaml: error: a pipeline needs 'matcher'; add 'matcher: NAME', NAME being one of "
            "fake_matcher");
  check_one("xgm: 2\nmatcher: {type: fake_matcher, cost: fake_cost}",
            "test.yaml:1:6: error: 'xgm' cannot be 2; give a whole number from 1 to 1");
  check_one("matcher: {cost: fake_cost}",
            "test.yaml:1:10: error: this matcher does not say which one it is; add 'type: NAME', "
            "NAME being one of fake_matcher");
  check_one("matcher: [fake_matcher]",
            "test.yaml:1:10: error: expected a matcher, found a list; write a name or {type: NAME, "
            "...}");
  check_one("matcher: {type: fake_matcher, cost: fake_cost, filters: fake_filter}",
            "test.yaml:1:57: error: 'filters' must be a list of stages of kind filter, not "
            "'fake_filter'; write it in brackets: [NAME, {type: NAME, ...}]");
  check_one("",
            "test.yaml: error: a pipeline file is a map of stages, this is nothing; start with "
            "'xgm: 1' and 'matcher: {type: ...}'");
}

TEST_CASE(
    "a rule is not judged while one of its own fields is faulty, but others do not silence it") {
  CHECK(load("matcher: {type: fake_matcher, cost: fake_cost, penalty: {type: fake_penalty, p1: x, "
             "p2: 1}}")
            .diagnostics.size() == 1);
  CHECK(load("matcher: {type: fake_matcher, cost: fake_cost, penalty: {type: fake_penalty, p1: 9, "
             "p2: 1, p3: 1}}")
            .diagnostics.size() == 2);
}

TEST_CASE("disparities are a pair in order") {
  const std::string rest = "\nmatcher: {type: fake_matcher, cost: fake_cost}";
  CHECK(load("disparities: [-3, 4]" + rest).pipeline->disparities() == Interval{-3, 5});
  CHECK_FALSE(load("xgm: 1" + rest).pipeline->disparities().has_value());
  for (const std::string bad : {"[4, 3]", "[1]", "[1, 2, 3]", "[0.5, 2]", "7", "[0, 1e9]"}) {
    CHECK_MESSAGE(load("disparities: " + bad + rest).diagnostics.size() == 1, bad);
  }
}

TEST_CASE("overrides replace, add, reach through bare words and lists, and name themselves") {
  const std::string text =
      "matcher: {type: fake_matcher, cost: fake_cost, filters: [fake_filter, fake_filter]}";
  const auto resolved = [&](const std::string& path, const std::string& value) {
    const LoadedPipeline loaded = load(text, {{path, value}});
    REQUIRE_MESSAGE(loaded.pipeline, messages(text, {{path, value}}));
    return loaded.pipeline->resolved_json();
  };
  CHECK(resolved("matcher.cost.window", "9").find("\"window\": 9") != std::string::npos);
  CHECK(resolved("matcher.filters", "[]").find("fake_filter") == std::string::npos);
  CHECK(resolved("matcher.filters[1]", "failing_filter").find("failing") != std::string::npos);
  CHECK(resolved("matcher.cost", "{type: fake_cost, sigma: 9}").find("9") != std::string::npos);

  CHECK(messages(text, {{"matcher.cost.windw", "9"}}) ==
        "--set matcher.cost.windw=9: error: fake_cost has no parameter 'windw'; did you mean "
        "'window'?\n");
  for (const std::string path :
       {"", ".", "matcher..cost", "matcher.filters[2]", "matcher.filters[x]", "matcher.filters[0",
        "matcher.filters.window"}) {
    CHECK_MESSAGE(load(text, {{path, "1"}}).diagnostics.size() == 1, path);
  }
  CHECK(load(text, {{"matcher.cost.window", "[1"}}).diagnostics.size() == 1);
}

TEST_CASE("anchors and aliases mean what they repeat") {
  CHECK(messages("matcher: {type: fake_matcher, cost: &c {type: fake_cost, window: 7}, "
                 "matcher: {type: fake_matcher, cost: *c}}") == "");
  CHECK(load("matcher: &m {type: fake_matcher, cost: fake_cost, matcher: *m}").diagnostics.size() ==
        1);
}

TEST_CASE("what is kept to be repeated counts as often as it is kept") {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "&a" + std::to_string(i) + " [";
  for (int i = 0; i < 5000; ++i) text += "x, ";
  const std::string reason = messages(text + std::string(50, ']'));
  CHECK_MESSAGE(reason.find("more than 20000 values") != std::string::npos, reason);
}

TEST_CASE("no text whatever crashes the reader") {
  std::vector<std::string> texts{"[",
                                 "{",
                                 "]",
                                 "}",
                                 "- - -",
                                 "? : ?",
                                 "a: b: c",
                                 "*x",
                                 "&x",
                                 "!!",
                                 "%YAML 9",
                                 "--- a\n--- b",
                                 "\xff\xfe\x00",
                                 std::string("a\0b", 3),
                                 "'",
                                 "\"",
                                 "|",
                                 ">",
                                 "\t",
                                 "a:\n\t- b",
                                 "<<: *a",
                                 "{a: 1, a: 2}",
                                 "? {a: b}\n: c",
                                 "[[]]: x"};
  texts.push_back(std::string(200000, '['));
  texts.push_back(std::string(200000, '{'));
  std::string deep, laughs = "a0: &a0 [x, x]\n";
  for (int i = 0; i < 20000; ++i) deep += "- ";
  for (int i = 1; i < 60; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    laughs += "a" + n + ": &a" + n + " [*a" + before + ", *a" + before + "]\n";
  }
  texts.push_back(deep);
  texts.push_back(laughs);
  std::string junk(1 << 20, ' ');
  std::uint32_t state = 1;
  for (char& c : junk) c = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  texts.push_back(junk);
  std::string printable = junk;
  for (char& c : printable) c = static_cast<char>(32 + static_cast<unsigned char>(c) % 95);
  texts.push_back(printable);
  for (const std::string& text : texts) {
    const LoadedPipeline loaded = load(text);
    CHECK_FALSE(loaded.pipeline.has_value());
    CHECK(!loaded.diagnostics.empty());
    for (const Diagnostic& d : loaded.diagnostics) CHECK(to_string(d).size() < 500);
  }
}
