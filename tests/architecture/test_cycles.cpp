// SPDX-License-Identifier: Apache-2.0
// Cycles between files and between folders are found, and told with the includes that close them.
#include <doctest/doctest.h>

#include "architecture/rules.hpp"
#include "architecture/told.hpp"

using namespace xgm::architecture;

namespace {

const std::string kData = "framework/core/include/xgm/data/";
const std::string kEvaluation = "framework/evaluation/";

std::string including(const std::string& target) { return "#include \"" + target + "\"\n"; }

bool names(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("architecture rules: cycles are found through any number of files") {
  CHECK(include_cycles({{kData + "a.hpp", including("xgm/data/b.hpp")},
                        {kData + "b.hpp", including("xgm/data/c.hpp")},
                        {kData + "c.hpp", "  #  include \"xgm/data/a.hpp\"\n"}}) ==
        Violations{"include cycle: " + kData + "a.hpp -> " + kData + "b.hpp -> " + kData +
                   "c.hpp -> " + kData + "a.hpp"});
  CHECK(include_cycles({{"plugins/cost/x/a.hpp", including("plugins/cost/x/a.hpp")}}).size() == 1);
  CHECK(include_cycles({{kEvaluation + "src/bench/a.hpp", including("bench/b.hpp")},
                        {kEvaluation + "src/bench/b.hpp", including("a.hpp")}})
            .size() == 1);
  CHECK(include_cycles({{kData + "a.hpp", including("xgm/data/c.hpp")},
                        {kData + "b.hpp", including("xgm/data/c.hpp")},
                        {kData + "c.hpp", ""}}) == Violations{});
}

TEST_CASE("architecture rules: folders of a room that include each other are told with the files") {
  const Violations found =
      folder_cycles({{kEvaluation + "src/bench/a.cpp", including("report/html.hpp")},
                     {kEvaluation + "src/report/html.hpp", including("record/json.hpp")},
                     {kEvaluation + "src/record/json.hpp", ""},
                     {kEvaluation + "src/record/json.cpp", including("bench/names.hpp")},
                     {kEvaluation + "src/bench/names.hpp", ""}});
  REQUIRE(found.size() == 1);
  CHECK(names(found[0], kEvaluation + "src/bench/a.cpp includes report/html.hpp"));
  CHECK(names(found[0], kEvaluation + "src/report/html.hpp includes record/json.hpp"));
  CHECK(names(found[0], kEvaluation + "src/record/json.cpp includes bench/names.hpp"));
}

TEST_CASE("architecture rules: a public header belongs to the folder that implements it") {
  // sparsification.cpp lies in metrics, and bench_tables.hpp is named for the folder bench.
  const std::string headers = kEvaluation + "include/xgm/evaluation/";
  Tree tree{{headers + "sparsification.hpp", ""},
            {headers + "bench_tables.hpp", ""},
            {kEvaluation + "src/metrics/sparsification.cpp",
             including("xgm/evaluation/bench_tables.hpp")},
            {kEvaluation + "src/bench/table.cpp", including("xgm/evaluation/sparsification.hpp")}};
  CHECK(folder_cycles(tree).size() == 1);
  tree[kEvaluation + "src/bench/table.cpp"] = "";
  CHECK(told(folder_cycles(tree)) == "");
}

TEST_CASE("architecture rules: cycles between folders of core, of plugins and of commands") {
  CHECK(folder_cycles({{kData + "image.hpp", including("xgm/config/a.hpp")},
                       {"framework/core/include/xgm/config/a.hpp", ""},
                       {"framework/core/src/config/a.cpp", including("xgm/data/image.hpp")}})
            .size() == 1);
  CHECK(folder_cycles({{"plugins/cost/x/a.hpp", including("plugins/cost/engine/b.hpp")},
                       {"plugins/cost/engine/b.hpp", ""},
                       {"plugins/cost/engine/b.cpp", including("plugins/cost/x/a.hpp")}})
            .size() == 1);
  CHECK(folder_cycles({{"apps/pipeline/run/run.cpp", including("plan/table.hpp")},
                       {"apps/pipeline/run/options.hpp", ""},
                       {"apps/pipeline/plan/table.hpp", including("run/options.hpp")}})
            .size() == 1);
}

TEST_CASE("architecture rules: folders in one direction, files of one folder, tests are no cycle") {
  CHECK(told(folder_cycles(
            {{"apps/pipeline/main.cpp", including("run/run.hpp") + including("terminal/t.hpp")},
             {"apps/pipeline/run/run.hpp", including("terminal/t.hpp") + including("run/x.hpp")},
             {"apps/pipeline/run/x.hpp", ""},
             {"apps/pipeline/terminal/t.hpp", ""},
             {"tests/docs/a.cpp", including("apps/program.hpp")},
             {"tests/apps/program.hpp", including("docs/blocks.hpp")},
             {"tests/docs/blocks.hpp", ""}})) == "");
}
