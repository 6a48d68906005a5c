// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/lookup.hpp"

#include <doctest/doctest.h>

#include "support/fake_stages.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

TEST_CASE("find_pipeline: a path, or a shipped name with or without its ending") {
  const TemporaryFolder folder;
  const std::string shipped = folder.write("tmgm16.yaml", "xgm: 1\n");
  folder.write("notes.txt", "");
  CHECK(find_pipeline("tmgm16", folder.path()) == shipped);
  CHECK(find_pipeline("tmgm16.yaml", folder.path()) == shipped);
  CHECK(find_pipeline(shipped, "/nowhere") == shipped);
  CHECK(shipped_pipelines(folder.path()) == std::vector<std::string>{"tmgm16.yaml"});
  CHECK(shipped_pipelines("/nowhere").empty());
}

TEST_CASE("find_pipeline: a miss lists the shipped names and guesses") {
  const TemporaryFolder folder;
  folder.write("sgm8.yaml", "");
  folder.write("tmgm16.yaml", "");
  const std::string miss = error_of([&] { find_pipeline("tmgm61", folder.path()); });
  CHECK(contains(miss, "did you mean 'tmgm16.yaml'?"));
  CHECK(contains(miss, "shipped are: sgm8.yaml, tmgm16.yaml"));
  CHECK(contains(error_of([&] { find_pipeline("notes.txt", folder.path()); }), "neither a file"));
  CHECK(contains(error_of([&] { find_pipeline("", folder.path()); }), "neither a file"));
  CHECK(contains(error_of([&] { find_pipeline(folder.path(), folder.path()); }),
                 "the pipeline comes first"));
}

TEST_CASE("find_plugins: by name, by kind and name, with a guess for a miss") {
  const Registry registry = xgm::testing::fake_registry();
  const PluginInfo* any = registry.plugins().front();
  CHECK_FALSE(find_plugins(any->name, registry).empty());
  REQUIRE(find_plugins(any->kind + "/" + any->name, registry).size() == 1);
  CHECK(find_plugins(any->kind + "/" + any->name, registry).front() == any);
  const std::string miss = error_of([&] { find_plugins(any->name + "x", registry); });
  CHECK(contains(miss, "did you mean"));
  CHECK(contains(error_of([&] { find_plugins("cots/" + any->name, registry); }),
                 "did you mean 'cost'?"));
  CHECK(contains(error_of([&] { require_kind("filters", xgm::testing::builtins()); }),
                 "did you mean 'filter'?"));
  CHECK_NOTHROW(require_kind("filter", xgm::testing::builtins()));
}
