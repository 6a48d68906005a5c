// SPDX-License-Identifier: Apache-2.0
// The rules of who may include whom notice planted violations, and nothing else.
#include <doctest/doctest.h>

#include "architecture/rules.hpp"
#include "architecture/told.hpp"

using namespace xgm::architecture;

namespace {

const std::string kCore = "framework/core/include/xgm/";
const std::string kCoreSource = "framework/core/src/";
const std::string kEvaluation = "framework/evaluation/include/xgm/evaluation/";

/// What is wrong with one include in one file of a tree that has these files beside.
Violations violations_of(const std::string& file, const std::string& include) {
  Tree tree;
  for (const char* path :
       {"framework/core/src/config/node.hpp", "framework/core/src/stage/planned.hpp",
        "framework/core/src/io/raster.hpp", "framework/evaluation/src/metrics/errors.hpp",
        "framework/synthesis/src/shape.hpp", "plugins/cost/census/census.cpp",
        "plugins/cost/census/bits.hpp", "plugins/cost/zncc/zncc.cpp",
        "plugins/cost/zncc/window.hpp", "plugins/cost/candidate_costs/candidates.hpp",
        "plugins/filter/window_loop/window.hpp", "apps/pipeline/terminal/console.hpp",
        "apps/pipeline/run/results.hpp", "apps/python/module.hpp"})
    tree[path] = "";
  tree[file] = "#include " + include + "\n";
  return forbidden_includes(tree);
}

void check_forbidden(const std::string& file, const std::string& include) {
  CAPTURE(file);
  CAPTURE(include);
  CHECK(violations_of(file, include).size() == 1);
}

void check_allowed(const std::string& file, const std::string& include) {
  CAPTURE(file);
  CHECK(told(violations_of(file, include)) == "");
}

}  // namespace

TEST_CASE("architecture rules: rooms stand on those below them only") {
  for (const char* header : {"\"xgm/evaluation/metrics.hpp\"", "<xgm/synthesis/generate.hpp>",
                             "\"xgm/testing/contract.hpp\""}) {
    check_forbidden(kCore + "io/a.hpp", header);
    check_forbidden(kCoreSource + "pipeline/a.cpp", header);
  }
  check_forbidden(kEvaluation + "a.hpp", "\"xgm/synthesis/generate.hpp\"");
  check_forbidden("framework/evaluation/src/bench/a.cpp", "\"xgm/testing/synthetic.hpp\"");
  check_forbidden("framework/synthesis/src/a.cpp", "\"xgm/evaluation/metrics.hpp\"");
  check_forbidden("framework/testing/src/a.cpp", "\"xgm/evaluation/metrics.hpp\"");
  check_forbidden("framework/attic/src/a.cpp", "\"xgm/base/error.hpp\"");
  check_allowed(kEvaluation + "a.hpp", "\"xgm/pipeline/pipeline.hpp\"");
  check_allowed(kEvaluation + "a.hpp", "\"xgm/evaluation/metrics.hpp\"");
  check_allowed("framework/synthesis/src/a.cpp", "\"xgm/io/scene.hpp\"");
  check_allowed("framework/testing/src/a.cpp", "\"xgm/synthesis/plain_scene.hpp\"");
}

TEST_CASE("architecture rules: private headers are for their own room") {
  check_forbidden("framework/evaluation/src/report/a.cpp", "\"config/node.hpp\"");
  check_forbidden("framework/evaluation/src/report/a.cpp", "\"../../../core/src/config/node.hpp\"");
  check_forbidden("framework/evaluation/src/report/a.cpp",
                  "\"framework/core/src/config/node.hpp\"");
  check_forbidden("framework/testing/src/a.cpp", "\"shape.hpp\"");
  check_forbidden("apps/pipeline/main.cpp", "\"config/node.hpp\"");
  check_forbidden("plugins/cost/census/census.cpp", "\"config/node.hpp\"");
  check_forbidden("plugins/cost/census/census.cpp",
                  "\"../../../framework/core/src/config/node.hpp\"");
  check_forbidden("plugins/cost/census/census.cpp", "\"framework/core/src/config/node.hpp\"");
  check_forbidden(kCore + "stage/a.hpp", "\"config/node.hpp\"");
  check_allowed("framework/evaluation/src/report/a.cpp", "\"metrics/errors.hpp\"");
  check_allowed("framework/synthesis/src/a.cpp", "\"shape.hpp\"");
}

TEST_CASE("architecture rules: the folders of core are layers, in public headers") {
  check_forbidden(kCore + "base/a.hpp", "\"xgm/data/image.hpp\"");
  check_forbidden(kCore + "data/a.hpp", "\"xgm/stage/cost.hpp\"");
  check_forbidden(kCore + "data/a.hpp", "\"xgm/config/parameters.hpp\"");
  check_forbidden(kCore + "config/a.hpp", "\"xgm/data/image.hpp\"");
  check_forbidden(kCore + "config/a.hpp", "\"xgm/plugin/registry.hpp\"");
  check_forbidden(kCore + "stage/a.hpp", "\"xgm/plugin.hpp\"");
  check_forbidden(kCore + "plugin.hpp", "\"xgm/pipeline.hpp\"");
  check_forbidden(kCore + "plugin/a.hpp", "\"xgm/io/pfm.hpp\"");
  check_forbidden(kCore + "io/a.hpp", "\"xgm/pipeline/pipeline.hpp\"");
  check_forbidden(kCore + "io/a.hpp", "\"xgm/exchange/program.hpp\"");
  check_allowed(kCore + "exchange/a.hpp", "\"xgm/io/pfm.hpp\"");
  check_forbidden(kCore + "new_folder/a.hpp", "\"xgm/base/error.hpp\"");
  check_allowed(kCore + "pipeline.hpp", "\"xgm/plugin/registry.hpp\"");
  check_allowed(kCore + "plugin.hpp", "\"xgm/plugin/handshake.hpp\"");
  check_allowed(kCore + "stage/a.hpp", "\"xgm/stage/b.hpp\"");
  check_allowed(kCore + "stage/a.hpp", "\"xgm/config/parameters.hpp\"");
}

TEST_CASE("architecture rules: the folders of core are layers, in sources") {
  check_forbidden(kCoreSource + "base/a.cpp", "\"xgm/data/image.hpp\"");
  check_forbidden(kCoreSource + "config/a.cpp", "\"xgm/stage/slot.hpp\"");
  check_forbidden(kCoreSource + "config/a.cpp", "\"stage/planned.hpp\"");
  check_forbidden(kCoreSource + "data/a.cpp", "\"config/node.hpp\"");
  check_forbidden(kCoreSource + "stage/a.cpp", "\"xgm/plugin.hpp\"");
  check_forbidden(kCoreSource + "plugin/a.cpp", "\"io/raster.hpp\"");
  check_forbidden(kCoreSource + "plugin/a.cpp", "<io/raster.hpp>");
  check_forbidden(kCoreSource + "io/a.cpp", "\"xgm/pipeline.hpp\"");
  check_forbidden(kCoreSource + "new_folder/a.cpp", "\"xgm/base/error.hpp\"");
  check_allowed(kCoreSource + "plugin/a.cpp", "\"config/node.hpp\"");
  check_allowed(kCoreSource + "pipeline/a.cpp", "\"io/raster.hpp\"");
}

TEST_CASE("architecture rules: other libraries stay out of public headers and of plugins") {
  for (const char* library : {"<yaml-cpp/yaml.h>", "<spdlog/spdlog.h>", "<CLI/CLI.hpp>",
                              "<nlohmann/json.hpp>", "<gdal_priv.h>", "<proj.h>"}) {
    check_forbidden(kCore + "config/a.hpp", library);
    check_forbidden(kEvaluation + "a.hpp", library);
    check_forbidden("plugins/cost/census/census.cpp", library);
    check_allowed(kCoreSource + "config/a.cpp", library);
  }
  check_forbidden(kCore + "data/a.hpp", "<opencv2/imgproc.hpp>");
  check_allowed(kCore + "data/a.hpp", "<opencv2/core.hpp>");
  check_allowed(kCore + "data/a.hpp", "<vector>");
}

TEST_CASE("architecture rules: a plugin includes the SDK, its own folder and its kind's engines") {
  const std::string census = "plugins/cost/census/census.cpp";
  check_forbidden(census, "\"plugins/cost/zncc/window.hpp\"");
  check_forbidden(census, "<plugins/cost/zncc/window.hpp>");
  check_forbidden(census, "\"plugins/cost/no_such_folder/window.hpp\"");
  check_forbidden(census, "\"plugins/filter/window_loop/window.hpp\"");
  check_forbidden(census, "\"bits.hpp\"");
  check_forbidden(census, "\"xgm/io/pfm.hpp\"");
  check_forbidden(census, "\"xgm/pipeline.hpp\"");
  check_forbidden(census, "\"xgm/evaluation/metrics.hpp\"");
  check_forbidden(census, "\"xgm/testing/contract.hpp\"");
  check_forbidden("plugins/cost/candidate_costs/a.hpp", "\"plugins/cost/census/bits.hpp\"");
  check_forbidden(census, "\"xgm/exchange/program.hpp\"");
  check_forbidden("plugins/cost/external/external.cpp", "\"xgm/io/pfm.hpp\"");
  check_allowed("plugins/cost/external/external.cpp", "\"xgm/exchange/program.hpp\"");
  check_allowed("plugins/matcher/precomputed/precomputed.cpp", "\"xgm/exchange/program.hpp\"");
  check_allowed(census, "\"plugins/cost/census/bits.hpp\"");
  check_allowed(census, "\"plugins/cost/candidate_costs/candidates.hpp\"");
  check_allowed(census, "\"xgm/plugin.hpp\"");
  check_allowed(census, "<opencv2/imgproc.hpp>");
}

TEST_CASE("architecture rules: the framework knows no plugin, application or test") {
  for (const char* header : {"\"plugins/cost/census/bits.hpp\"", "<plugins/cost/census/bits.hpp>",
                             "\"apps/pipeline/run/results.hpp\"", "\"tests/support/simd.hpp\""})
    check_forbidden(kCoreSource + "pipeline/a.cpp", header);
}

TEST_CASE("architecture rules: applications include public headers and their own files") {
  const std::string main = "apps/pipeline/main.cpp";
  check_forbidden(main, "\"xgm/plugin.hpp\"");
  check_forbidden(main, "\"xgm/stage/cost.hpp\"");
  check_forbidden(main, "\"xgm/config/parameters.hpp\"");
  check_forbidden(main, "\"xgm/testing/contract.hpp\"");
  check_forbidden(main, "\"plugins/cost/census/bits.hpp\"");
  check_forbidden(main, "\"../python/module.hpp\"");
  check_forbidden(main, "\"no_such_file.hpp\"");
  check_allowed(main, "\"xgm/pipeline.hpp\"");
  check_allowed(main, "\"xgm/stage/context.hpp\"");
  check_allowed(main, "\"xgm/evaluation/metrics.hpp\"");
  check_allowed(main, "\"xgm/synthesis/generate.hpp\"");
  check_allowed(main, "<CLI/CLI.hpp>");
  check_allowed("apps/pipeline/eval/eval.cpp", "\"terminal/console.hpp\"");
  check_allowed("apps/pipeline/run/run.cpp", "\"results.hpp\"");
}

TEST_CASE("architecture rules: the Python package makes stages, and tests none") {
  const std::string stages = "apps/python/src/python_stages.cpp";
  check_allowed(stages, "\"xgm/stage/cost.hpp\"");
  check_allowed(stages, "\"xgm/config/parameters.hpp\"");
  check_allowed(stages, "<pybind11/pybind11.h>");
  check_forbidden(stages, "\"xgm/testing/contract.hpp\"");
  check_forbidden(stages, "\"apps/pipeline/run/results.hpp\"");
}
