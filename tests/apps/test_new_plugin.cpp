// SPDX-License-Identifier: Apache-2.0
// pipeline new-plugin: folders, names and mistakes. That what it writes builds and keeps its
// contract is tested in out_of_tree/new_plugins.sh, and python/new_plugin for Python.
#include <doctest/doctest.h>

#include <filesystem>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/testing/new_plugin.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

Outcome begin(const TemporaryFolder& folder, const std::string& arguments,
              const std::string& before = {}) {
  return xgm::testing::pipeline(folder.path(), "new-plugin " + arguments, before);
}

/// Exit code 2, these words, and nothing left but what the shell wrote.
void check_refused(const TemporaryFolder& folder, const std::string& arguments,
                   const std::string& words) {
  CAPTURE(arguments);
  const auto before = folder.files();
  const Outcome outcome = begin(folder, arguments);
  CHECK(outcome.exit_code == 2);
  CHECK_MESSAGE(contains(outcome.errors, words), outcome.errors);
  CHECK(folder.files() == before);
}

}  // namespace

TEST_CASE("new-plugin: every kind of the core has a template") {
  const auto kinds = xgm::testing::template_kinds(xgm::testing::Language::cpp);
  std::vector<std::string> expected;
  const Registry registry;
  for (const KindInfo& kind : registry.kinds()) expected.push_back(kind.name);
  std::sort(expected.begin(), expected.end());
  CHECK(kinds == expected);
}

TEST_CASE("new-plugin: the folder has source, test, pipeline and how to go on, renamed") {
  const TemporaryFolder folder;
  const Outcome outcome = begin(folder, "cost rank_difference");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "written: rank_difference; rank_difference/README.md"));
  for (const char* name : {"CMakeLists.txt", "README.md", "pipeline.yaml", "rank_difference.cpp",
                           "test_rank_difference.cpp"}) {
    CHECK_MESSAGE(fs::exists(folder / "rank_difference" + ("/" + std::string(name))), name);
  }
  const std::string source = read_file(folder / "rank_difference/rank_difference.cpp");
  CHECK(contains(source, "class RankDifference final : public xgm::Cost"));
  CHECK(contains(source, "registry.add<RankDifference>(\"rank_difference\""));
  CHECK_FALSE(contains(source, "SPDX"));
  CHECK(begin(folder, "filter near_only --python --output stages").exit_code == 0);
  CHECK(fs::exists(folder / "stages/test_near_only.py"));
  CHECK_FALSE(fs::exists(folder / "stages/CMakeLists.txt"));
}

TEST_CASE("new-plugin: what cannot be begun is one message, and nothing is written") {
  const TemporaryFolder folder;
  folder.write("stderr.txt", "");
  folder.write("here", "a file");
  check_refused(folder, "cost census", "there is a cost called 'census' already (built in)");
  check_refused(folder, "cots mine", "there is no kind 'cots'; did you mean 'cost'?");
  for (const char* name : {"My", "9lives", "a-b", "../x", "ärger", "''"}) {
    check_refused(folder, "cost " + std::string(name), "is no name of a plugin");
  }
  check_refused(folder, "cost test", "has another meaning");
  check_refused(folder, "cost here", "--output here: is there already");
  check_refused(folder, "cost mine --output no/mine", "to make it in");
  check_refused(folder, "penalty mine --python",
                "there is no template for kind 'penalty' in Python");
#ifdef XGM_HAS_GEO
  check_refused(folder, "fusion mine", "there is no template for kind 'fusion'");
#endif
}

TEST_CASE("new-plugin: a folder that cannot be written leaves nothing behind") {
  const TemporaryFolder folder;
  folder.write("stderr.txt", "");
  const Outcome outcome = begin(folder, "cost mine", "ulimit -f 0 && ");
  CHECK(outcome.exit_code == 1);
  CHECK(folder.files() == 1);
}
