// SPDX-License-Identifier: Apache-2.0
// pipeline check-plugin: what it says of good, bad and deadly plugin files.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/testing/new_plugin.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

Outcome check(const std::string& arguments) {
  const TemporaryFolder folder;
  return xgm::testing::pipeline(folder.path(), "check-plugin " + arguments);
}

const std::string kBad = XGM_MISBEHAVING_PLUGINS;
const std::string kGood = XGM_EXAMPLE_PLUGINS;

/// What is printed of one stage, its own line included.
std::string part_of(const std::string& output, const std::string& stage) {
  std::istringstream lines(output);
  std::string part;
  for (std::string line; std::getline(lines, line);) {
    if (part.empty() ? line == stage : line.starts_with(' ')) {
      part += line + '\n';
    } else if (!part.empty()) {
      break;
    }
  }
  return part;
}

}  // namespace

TEST_CASE("check-plugin: a good file passes each check by name, exit 0") {
  const Outcome outcome = check(kGood + "/xgm_trim_border.so");
  INFO(outcome.output, outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "filter trim_border\n  passed  grey image\n"));
  CHECK(contains(outcome.output, "  passed  image of one pixel\n"));
  CHECK(contains(outcome.output, "1 of 1 stages keep their contracts"));
  CHECK_FALSE(contains(outcome.output, "FAILED"));
}

TEST_CASE("check-plugin: a stage that needs another one is told so, and is given it") {
  const Outcome without = check(kGood + "/xgm_upside_down.so");
  CHECK(without.exit_code == 1);
  CHECK(contains(without.output, "cannot be made"));
  CHECK(contains(without.output, "upside_down needs 'matcher'"));
  const std::string matcher =
      " --set 'upside_down.matcher={type: semi_global, cost: census, penalty: constant, "
      "aggregation: sgm}'";
  const Outcome with = check(kGood + "/xgm_upside_down.so" + matcher);
  INFO(with.output, with.errors);
  CHECK(with.exit_code == 0);
  const Outcome typo = check(kGood + "/xgm_upside_down.so --set upsidedown.matcher=opencv_sgbm");
  CHECK(typo.exit_code == 2);
  CHECK(contains(typo.errors, "did you mean 'upside_down'?"));
}

TEST_CASE("check-plugin: the bad sample of each kind fails in each check") {
  const Outcome outcome = check(kBad + "/xgm_bad_sample.so");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 1);
  for (const std::string& kind : xgm::testing::template_kinds(xgm::testing::Language::cpp)) {
    const std::string part = part_of(outcome.output, kind + " bad_" + kind);
    CHECK_MESSAGE(contains(part, "FAILED"), kind);
    CHECK_MESSAGE(!contains(part, "passed"), part);
  }
}

TEST_CASE("check-plugin: a stage that ends the process is told by the check in which it did") {
  const Outcome outcome = check(kBad + "/xgm_deadly.so --time-limit 2");
  INFO(outcome.output, outcome.errors);
  CHECK(outcome.exit_code == 1);
  const auto dies = [&](const char* stage, const char* how) {
    const std::string part = part_of(outcome.output, std::string("filter ") + stage);
    CHECK(contains(part, "  passed  grey image\n"));
    CHECK(contains(
        part, std::string("  FAILED  image of one pixel\n            the stage dies: ") + how));
    CHECK(contains(part, "the checks after 'image of one pixel' were not made"));
    CHECK(contains(part, "  skipped image of one row\n"));
  };
  dies("crashes", "");
  dies("leaves", "it ended the process with exit code 0");
  dies("hangs", "it takes longer than 2 s");
  CHECK(contains(outcome.output, "0 of 3 stages keep their contracts"));
}

TEST_CASE("check-plugin --json: files, stages and checks with what was found, and the same exit") {
  const auto json_of = [](const std::string& arguments, int exit_code) {
    const Outcome outcome = check(arguments + " --json");
    INFO(outcome.errors);
    CHECK(outcome.exit_code == exit_code);
    return nlohmann::json::parse(outcome.output);  // nothing else is printed there
  };
  const std::string file = kGood + "/xgm_trim_border.so";
  const auto good = json_of(file, 0);
  CHECK(good["file"] == file);
  CHECK(good["passed"] == true);
  CHECK(good["message"].is_null());
  REQUIRE(good["stages"].size() == 1);
  CHECK(good["stages"][0]["kind"] == "filter");
  CHECK(good["stages"][0]["name"] == "trim_border");
  const auto checks = good["stages"][0]["checks"];
  CHECK(checks.size() > 10);
  for (const auto& made : checks) {
    CHECK(made["result"] == "passed");
    CHECK(made["messages"].empty());
  }
  const auto deadly = json_of(kBad + "/xgm_deadly.so --time-limit 2", 1);
  CHECK(deadly["passed"] == false);
  for (const auto& stage : deadly["stages"]) {
    CHECK(stage["passed"] == false);
    CHECK(stage["message"] == "the checks after 'image of one pixel' were not made");
    bool is_dead = false;
    std::size_t i = 0;
    for (const auto& made : stage["checks"]) {  // by the names, in the order of the good stage
      CHECK(made["name"] == checks[i++]["name"]);
      const bool dies_here = made["name"] == "image of one pixel";
      CHECK(made["result"] == (dies_here ? "failed" : is_dead ? "skipped" : "passed"));
      if (dies_here) CHECK(contains(made["messages"][0], "the stage dies: "));
      is_dead = is_dead || dies_here;
    }
    CHECK(i == checks.size());
  }
  const auto missing = json_of("missing.so", 1);
  CHECK(missing["stages"].empty());
  CHECK(missing["message"] == "there is no such file");
  const auto unmade = json_of(kGood + "/xgm_upside_down.so", 1)["stages"][0];
  CHECK(contains(unmade["message"], "upside_down needs 'matcher'"));
  CHECK(unmade["checks"].empty());
}

TEST_CASE("check-plugin: a file that dies or cannot be loaded is told with the reason") {
  const Outcome deadly = check(kBad + "/xgm_deadly_to_load.so");
  CHECK(deadly.exit_code == 1);
  CHECK(contains(deadly.output, "dies while it is loaded"));
  const Outcome missing = check("missing.so");
  CHECK(missing.exit_code == 1);
  CHECK(contains(missing.output, "missing.so: FAILED: there is no such file"));
  CHECK(check("missing.so --time-limit 0").exit_code == 2);
}
