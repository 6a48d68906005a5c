// SPDX-License-Identifier: Apache-2.0
// The source tree keeps the rules, and the rules notice planted faults.
#include <doctest/doctest.h>

#include "architecture/rules.hpp"

using namespace xgm::architecture;

namespace {

/// For failure messages.
std::string told(const Faults& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  return text;
}

/// What is wrong with one include in one file.
Faults faults_of(const std::string& file, const std::string& include) {
  return forbidden_includes({{file, "#include " + include + "\n"}});
}

void check_forbidden(const std::string& file, const std::string& include) {
  CAPTURE(file);
  CAPTURE(include);
  CHECK(faults_of(file, include).size() == 1);
}

void check_allowed(const std::string& file, const std::string& include) {
  CHECK(told(faults_of(file, include)) == "");
}

const Tree& sources() {
  static const Tree tree = read_tree(XGM_SOURCE_DIR);
  return tree;
}

}  // namespace

TEST_CASE("architecture: the sources are found") {
  CHECK(sources().contains("framework/include/xgm/pipeline.hpp"));
  CHECK(sources().contains("tests/architecture/rules.cpp"));
  CHECK(sources().size() > 50);
}

TEST_CASE("architecture: no include points up or across") {
  CHECK(told(forbidden_includes(sources())) == "");
}

TEST_CASE("architecture: there is no include cycle") {
  CHECK(told(include_cycles(sources())) == "");
}

TEST_CASE("architecture: every source begins with its licence") {
  CHECK(told(missing_licences(sources())) == "");
}

TEST_CASE("architecture: no file is longer than 500 lines") {
  CHECK(told(long_files(sources())) == "");
}

TEST_CASE("architecture rules: SDK layers may include lower ones only") {
  const std::string sdk = "framework/include/xgm/";
  check_forbidden(sdk + "base/a.hpp", "\"xgm/data/image.hpp\"");
  check_forbidden(sdk + "data/a.hpp", "\"xgm/stage/cost.hpp\"");
  check_forbidden(sdk + "data/a.hpp", "\"xgm/config/parameters.hpp\"");
  check_forbidden(sdk + "config/a.hpp", "\"xgm/plugin/registry.hpp\"");
  check_forbidden(sdk + "stage/a.hpp", "\"xgm/plugin.hpp\"");
  check_forbidden(sdk + "plugin.hpp", "\"xgm/pipeline/pipeline.hpp\"");
  check_forbidden(sdk + "plugin/a.hpp", "\"xgm/io/pfm.hpp\"");
  check_forbidden(sdk + "pipeline.hpp", "\"xgm/synthesis/plain_scene.hpp\"");
  check_forbidden(sdk + "stage/a.hpp", "\"config/node.hpp\"");
  check_allowed(sdk + "pipeline.hpp", "\"xgm/plugin/registry.hpp\"");
  check_forbidden(sdk + "new_folder/a.hpp", "\"xgm/base/error.hpp\"");
  check_forbidden(sdk + "data/a.hpp", "\"xgm/evaluation/metrics.hpp\"");
  check_allowed(sdk + "run_record.hpp", "\"xgm/io/scene.hpp\"");
  check_allowed(sdk + "plugin.hpp", "\"xgm/plugin/handshake.hpp\"");
  check_allowed(sdk + "stage/a.hpp", "\"xgm/stage/b.hpp\"");
  check_allowed(sdk + "testing/a.hpp", "\"xgm/stage/cost.hpp\"");
  check_allowed(sdk + "data/a.hpp", "<opencv2/core.hpp>");
}

TEST_CASE("architecture rules: inner libraries stay out of the SDK and of plugins") {
  for (const char* library :
       {"<yaml-cpp/yaml.h>", "<spdlog/spdlog.h>", "<CLI/CLI.hpp>", "<nlohmann/json.hpp>"}) {
    check_forbidden("framework/include/xgm/config/a.hpp", library);
    check_forbidden("plugins/cost/census/census.cpp", library);
    check_allowed("framework/src/a.cpp", library);
  }
}

TEST_CASE("architecture rules: a plugin includes the SDK and its own folder only") {
  const std::string census = "plugins/cost/census/census.cpp";
  check_forbidden(census, "\"plugins/cost/zncc/window.hpp\"");
  check_forbidden(census, "\"plugins/cost/census_wide/window.hpp\"");
  check_forbidden(census, "\"plugins/filter/shared/window.hpp\"");
  check_forbidden(census, "\"config/node.hpp\"");
  check_forbidden(census, "\"../../../framework/src/config/node.hpp\"");
  check_forbidden(census, "\"framework/src/config/node.hpp\"");
  check_forbidden(census, "\"xgm/pipeline/pipeline.hpp\"");
  check_forbidden("plugins/cost/candidate_costs/a.hpp", "\"plugins/cost/census/bits.hpp\"");
  check_allowed(census, "\"plugins/cost/census/bits.hpp\"");
  check_allowed(census, "\"plugins/cost/candidate_costs/window.hpp\"");
  check_allowed(census, "\"xgm/plugin.hpp\"");
  check_allowed(census, "<opencv2/imgproc.hpp>");
}

TEST_CASE("architecture rules: the framework knows no plugin, applications only the facade") {
  check_forbidden("framework/src/a.cpp", "\"plugins/cost/census/bits.hpp\"");
  check_forbidden("apps/pipeline/main.cpp", "\"xgm/plugin.hpp\"");
  check_forbidden("apps/pipeline/main.cpp", "\"xgm/stage/cost.hpp\"");
  check_forbidden("apps/pipeline/main.cpp", "\"plugins/cost/census/bits.hpp\"");
  check_forbidden("apps/pipeline/main.cpp", "\"config/node.hpp\"");
  check_allowed("apps/pipeline/main.cpp", "\"xgm/pipeline/pipeline.hpp\"");
  check_allowed("apps/pipeline/main.cpp", "<CLI/CLI.hpp>");
  CHECK(forbidden_includes({{"apps/pipeline/main.cpp", "#include \"scene.hpp\"\n"},
                            {"apps/pipeline/scene.hpp", ""}}) == Faults{});
}

TEST_CASE("architecture rules: cycles are found through any number of files") {
  const std::string sdk = "framework/include/xgm/data/";
  CHECK(include_cycles({{sdk + "a.hpp", "#include \"xgm/data/b.hpp\"\n"},
                        {sdk + "b.hpp", "#include \"xgm/data/c.hpp\"\n"},
                        {sdk + "c.hpp", "  #  include \"xgm/data/a.hpp\"\n"}})
            .size() == 1);
  CHECK(include_cycles({{"plugins/cost/x/a.hpp", "#include \"plugins/cost/x/a.hpp\"\n"}}).size() ==
        1);
  CHECK(include_cycles({{sdk + "a.hpp", "#include \"xgm/data/c.hpp\"\n"},
                        {sdk + "b.hpp", "#include \"xgm/data/c.hpp\"\n"},
                        {sdk + "c.hpp", ""}}) == Faults{});
}

TEST_CASE("architecture rules: licence and length are seen") {
  CHECK(missing_licences({{"a.cpp", "// Copyright someone\n"}}).size() == 1);
  CHECK(missing_licences({{"a.cpp", ""}}).size() == 1);
  CHECK(missing_licences({{"a.cmake", "# SPDX-License-Identifier: Apache-2.0\n"}}) == Faults{});
  CHECK(long_files({{"a.cpp", std::string(501, '\n')}}).size() == 1);
  CHECK(long_files({{"a.cpp", std::string(500, '\n')}}) == Faults{});
}
