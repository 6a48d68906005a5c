// SPDX-License-Identifier: Apache-2.0
// pipeline tune, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

/// Four small scenes, and a pipeline with penalties that are far too high.
struct Desk : TemporaryFolder {
  Desk() {
    write("p.yaml",
          "xgm: 1\n"
          "matcher:\n"
          "  type: semi_global\n"
          "  cost: census\n"
          "  penalty: {type: constant, p1: 3000, p2: 3000}\n"
          "  aggregation: {type: sgm, directions: 4}\n");
    REQUIRE(call("synth scenes --count 4 --size 60x40 --disparities 0:9").exit_code == 0);
  }
  Outcome call(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), arguments);
  }
  Outcome tune(const std::string& arguments) const {
    return call("tune p.yaml --data scenes --threads 1 " + arguments);
  }
};

const std::string kOver =
    "--over matcher.penalty.p1=4..30 --over matcher.penalty.p2=20..200:log --budget 16 ";

}  // namespace

TEST_CASE("tune: writes a table, tune.json and a pipeline that is better on scenes held back") {
  const Desk desk;
  const Outcome outcome = desk.tune(kOver + "--seed 3 --output first");
  INFO(outcome.output, outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "held back: 1 scene"));
  CHECK(contains(read_file(desk / "first/tune.md"), "p (as it is)"));
  const auto json = nlohmann::json::parse(read_file(desk / "first/tune.json"));
  CHECK(json["runs"] <= 16);
  CHECK(json["best"]["held_out"].get<double>() < json["start"]["held_out"].get<double>());
  const Outcome best = desk.call("run first/best.yaml scenes --scene " +
                                 json["held_out_scenes"][0].get<std::string>() + " --output best");
  INFO(best.errors);
  CHECK(best.exit_code == 0);

  const Outcome again = desk.tune(kOver + "--seed 3 --output second");
  CHECK(again.exit_code == 0);
  CHECK(read_file(desk / "first/tune.json") == read_file(desk / "second/tune.json"));
}

TEST_CASE("tune: mistakes are told before any run, exit 2") {
  const Desk desk;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = desk.tune(arguments + " --output none");
    CAPTURE(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_MESSAGE(contains(outcome.errors, words), outcome.errors);
    CHECK_FALSE(std::filesystem::exists(desk / "none"));
  };
  refused("--over matcher.penalty.p3=1,2 --budget 20", "has no parameter 'p3'");
  refused("--over matcher.cost=census,cenus --budget 20", "did you mean 'census'?");
  refused("--over matcher.penalty.p1=9..1 --budget 20", "must begin below its end");
  refused(kOver + "--held-out 1", "--held-out");
  refused("--over matcher.penalty.p1=0,0 --budget 20", "is given twice");
  refused("--over matcher.penalty.p1=5,9 --budget 3", "--budget 3: two pipelines on all scenes");
  refused(kOver + "--scenes nothing", "there is no scene 'nothing'");
}

TEST_CASE("tune: the pipeline to better is never lost to the best one") {
  const Desk desk;
  std::filesystem::create_directory(desk / "xgm_tune");
  std::filesystem::copy_file(desk / "p.yaml", desk / "xgm_tune/best.yaml");
  const std::string before = read_file(desk / "xgm_tune/best.yaml");
  const Outcome outcome = desk.call("tune xgm_tune/best.yaml --data scenes " + kOver);
  CHECK(outcome.exit_code == 2);
  CHECK(read_file(desk / "xgm_tune/best.yaml") == before);
}
