// SPDX-License-Identifier: Apache-2.0
// What people are used to write in YAML, or save it as: it works, or the message says what to
// write.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "support/fake_stages.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/pipeline/pipeline.hpp"

using namespace xgm;
using xgm::testing::contains;

namespace {

LoadedPipeline load(const std::string& text, const std::vector<Override>& overrides = {}) {
  static const Registry registry = xgm::testing::fake_registry();
  return load_pipeline_text(text, "test.yaml", registry, overrides);
}

std::string messages(const std::string& text, const std::vector<Override>& overrides = {}) {
  return to_string(load(text, overrides).diagnostics);
}

void check_message(const std::string& text, const std::string& expected) {
  const LoadedPipeline loaded = load(text);
  CHECK(loaded.diagnostics.size() == 1);
  CHECK_MESSAGE(contains(to_string(loaded.diagnostics), "test.yaml:" + expected),
                to_string(loaded.diagnostics));
}

std::string with_cost(const std::string& parameters) {
  return "matcher: {type: fake_matcher, cost: {type: fake_cost, " + parameters + "}}";
}

const std::string kSound = "xgm: 1\nmatcher:\n  type: fake_matcher\n  cost: fake_cost\n";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  REQUIRE(begin != std::string::npos);
  return text.replace(begin, from.size(), to);
}

}  // namespace

TEST_CASE("merge keys: entries of another map, except those that the map has itself") {
  const auto resolved = [](const std::string& text) {
    const LoadedPipeline loaded = load(text);
    REQUIRE_MESSAGE(loaded.pipeline, to_string(loaded.diagnostics));
    return loaded.pipeline->resolved_json();
  };
  const auto matchers = [](const std::string& outer, const std::string& inner) {
    return "matcher: {type: fake_matcher, cost: " + outer +
           ", matcher: {type: fake_matcher, cost: " + inner + "}}";
  };
  const std::string anchor = "&c {type: fake_cost, window: 7, sigma: 2.5}";
  CHECK(resolved(matchers(anchor, "{<<: *c}")) == resolved(matchers(anchor, "*c")));
  const std::string expected =
      resolved(matchers(anchor, "{type: fake_cost, window: 9, sigma: 2.5}"));
  CHECK(resolved(matchers(anchor, "{<<: *c, window: 9}")) == expected);
  CHECK(resolved(matchers(anchor, "{window: 9, <<: *c}")) == expected);
  CHECK(resolved(matchers(anchor, "{<<: [{window: 9}, *c]}")) == expected);
  CHECK(resolved(matchers(anchor, "{<<: {window: 9, sigma: 2.5}, type: fake_cost}")) == expected);
}

TEST_CASE("merge keys: what cannot be merged is told") {
  check_message(with_cost("<<: 5"),
                "1:55: error: '<<' merges maps, and this is none; write '<<: *");
  check_message(with_cost("<<: "), "1:55: error: '<<' merges maps");
  check_message(with_cost("<<: [a]"), "1:55: error: '<<' merges maps");
  check_message(with_cost("<<: {window: 5}, <<: {sigma: 2}"),
                "1:72: error: key '<<' appears twice");
  check_message(with_cost("<<: {window: 5, window: 7}, sigma: 2"),
                "1:71: error: key 'window' appears");
  check_message(with_cost("'<<': {window: 5}"), "1:55: error: fake_cost has no parameter '<<'");
}

TEST_CASE("aliases: a fault that is repeated is told once; an unknown one with its remedy") {
  check_message(
      "matcher: {type: fake_matcher, cost: &c {type: fake_cost, windw: 7}, "
      "matcher: {type: fake_matcher, cost: *c}}",
      "1:58: error: fake_cost has no parameter 'windw'");
  check_message(changed(kSound, "fake_cost", "*cost"),
                "4:9: error: not valid YAML: the referenced anchor is not defined; mark what is");
}

TEST_CASE("a tab or a no-break space that indents is named with its line") {
  check_message(changed(kSound, "  cost", "\tcost"),
                "4:1: error: a tab indents this line; YAML is");
  check_message(changed(kSound, "  type", "\ttype"), "3:1: error: a tab indents this line");
  check_message(changed(kSound, "  cost", "  \tcost"), "4:3: error: a tab indents this line");
  check_message(changed(kSound, "  cost",
                        " \xC2\xA0"
                        "cost"),
                "4:2: error: a no-break space indents");
  CHECK(messages(changed(kSound, "cost: ", "cost:\t")) == "");
}

TEST_CASE("one document: a second one is told with its place") {
  CHECK(messages("%YAML 1.2\n---\n" + kSound + "...\n") == "");
  check_message(kSound + "---\n" + kSound, "5:1: error: holds more than one document; remove this");
}

TEST_CASE("encodings: marks and line ends mean nothing, other than UTF-8 is told") {
  CHECK(messages("\xEF\xBB\xBF" + kSound) == "");
  std::string windows = kSound, old = kSound;
  for (std::size_t i = windows.find('\n'); i != std::string::npos; i = windows.find('\n', i + 2)) {
    windows.insert(i, "\r");
  }
  std::replace(old.begin(), old.end(), '\n', '\r');
  CHECK(messages(windows) == "");
  CHECK(messages(old) == "");
  CHECK(messages("# gr\xF6\xDF"
                 "er\n" +
                 kSound) == "");
  check_message(changed(kSound, "fake_cost", "fake_c\xF6st"),
                "4:9: error: 'fake_c\xF6"
                "st' is not in UTF-8; save");
  CHECK(contains(messages(std::string("\xFF\xFEx\0g\0", 6)), "holds zero bytes, as UTF-16 does"));
}

TEST_CASE("tags: those of YAML itself are harmless, others are told") {
  CHECK(messages(with_cost("window: !!int 7")) == "");
  check_message(changed(kSound, "fake_cost", "!include cost.yaml"),
                "4:9: error: the tag '!include' has no");
  check_message("!pipeline\n" + kSound, "1:1: error: the tag '!pipeline' has no meaning");
}

TEST_CASE("numbers of other spellings: the message says what to write") {
  for (const std::string good :
       {"sigma: .5", "sigma: 5.", "sigma: 1e1", "window: 07", "clamp: TRUE"}) {
    CHECK_MESSAGE(messages(with_cost(good)) == "", good);
  }
  const auto check = [](const std::string& value, const std::string& remedy) {
    const std::string told = messages(with_cost(value));
    CHECK_MESSAGE(contains(told, "test.yaml:1:"), told);
    CHECK_MESSAGE(told.ends_with("; " + remedy), told);
  };
  check("sigma: 1_0", "write 10");
  check("sigma: 0x10", "write 16");
  check("window: 0b111", "write 7");
  check("window: 0o7", "write 7");
  check("window: 7.0", "write 7");
  check("window: 1e1", "change the value");  // 10 is even
  check("window: 7.5", "change the value");
  check("sigma: .inf", "change the value");
  check("sigma: +-5", "change the value");
  check("clamp: yes", "write true");
  check("clamp: Off", "write false");
  CHECK(messages(with_cost("window: 5"), {{"matcher.cost.sigma", "1,5"}}).ends_with("; write 1.5"));
  check_message(with_cost("sigma: 1,5"),
                "1:64: error: fake_cost has no parameter '5'; the comma before");
}
