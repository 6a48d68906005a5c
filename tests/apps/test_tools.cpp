// SPDX-License-Identifier: Apache-2.0
// pipeline check, list, describe, graph and schema, as a user meets them.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

Outcome call(const TemporaryFolder& folder, const std::string& arguments) {
  return xgm::testing::pipeline(folder.path(), arguments);
}

}  // namespace

TEST_CASE("check: ok lines for sound files, all faults of all others, exit 2") {
  const TemporaryFolder folder;
  folder.write("bad.yaml", "xgm: 1\nmatcher:\n  type: opencv_sgbm\n  mode: 3\n  uniquenes: 1\n");
  folder.write("worse.yaml", "- 1\n");
  const Outcome good = call(folder, "check sgm8 opencv_sgbm.yaml");
  INFO(good.errors);
  CHECK(good.exit_code == 0);
  CHECK(std::count(good.output.begin(), good.output.end(), '\n') == 2);
  const Outcome mixed = call(folder, "check bad.yaml sgm8 worse.yaml missing.yaml");
  CHECK(mixed.exit_code == 2);
  CHECK(contains(mixed.errors, "bad.yaml:4:"));
  CHECK(contains(mixed.errors, "bad.yaml:5:3: error: "));
  CHECK(contains(mixed.errors, "worse.yaml"));
  CHECK(contains(mixed.errors, "missing.yaml"));
  CHECK(contains(mixed.output, "sgm8.yaml: ok"));
  CHECK(call(folder, "check sgm8 --set matcher.nothing=1").exit_code == 2);
  CHECK(call(folder, "check").exit_code == 2);
}

TEST_CASE("list: all plugins, one kind, failures; an unknown kind is a usage error") {
  const TemporaryFolder folder;
  folder.write("junk.so", "junk");
  const Outcome all = call(folder, "list --plugin junk.so");
  CHECK(all.exit_code == 0);
  CHECK(contains(all.output, "census"));
  CHECK(contains(all.output, "[built in]"));
  CHECK(contains(all.output, "not loaded: junk.so: "));
  const Outcome costs = call(folder, "list cost");
  CHECK(contains(costs.output, "census"));
  CHECK_FALSE(contains(costs.output, "left_right"));
  const Outcome unknown = call(folder, "list cots");
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.errors, "did you mean 'cost'?"));
}

TEST_CASE("describe: for people and for programs") {
  const TemporaryFolder folder;
  const Outcome text = call(folder, "describe census");
  CHECK(text.exit_code == 0);
  CHECK(contains(text.output, "window"));
  const Outcome json = call(folder, "describe cost/census --json");
  CHECK(nlohmann::json::parse(json.output)["name"] == "census");
  const Outcome unknown = call(folder, "describe cenus");
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.errors, "did you mean 'census'?"));
}

TEST_CASE("graph: the stages with every parameter, overrides applied") {
  const TemporaryFolder folder;
  const Outcome graph = call(folder, "graph sgm8 --set matcher.consistency.threshold=2");
  INFO(graph.errors);
  CHECK(graph.exit_code == 0);
  CHECK(contains(graph.output, "census"));
  CHECK(call(folder, "graph missing").exit_code == 2);
}

TEST_CASE("schema is JSON; help and version are exit 0") {
  const TemporaryFolder folder;
  const Outcome schema = call(folder, "schema");
  CHECK(schema.exit_code == 0);
  CHECK(nlohmann::json::parse(schema.output).contains("$schema"));
  CHECK(contains(call(folder, "--version").output, "xgm "));
  const Outcome help = call(folder, "run --help");
  CHECK(help.exit_code == 0);
  CHECK(contains(help.output, "both included"));
}
