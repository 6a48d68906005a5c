// SPDX-License-Identifier: Apache-2.0
// pipeline doctor: a sound installation is exit 0; what is broken is named, exit 1.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "apps/program.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

Outcome doctor(const std::string& arguments, const std::string& before = {}) {
  const TemporaryFolder folder;
  folder.write("junk.so", "junk");
  return xgm::testing::pipeline(folder.path(), "doctor " + arguments, before);
}

}  // namespace

TEST_CASE("doctor: says what it found, and that nothing is broken") {
  const Outcome outcome = doctor("");
  INFO(outcome.output, outcome.errors);
  CHECK(outcome.exit_code == 0);
  for (const char* text : {"xgm ", "SIMD target ", "can be taken", "XGM_PLUGIN_PATH is not set",
                           "for each run", "can be run", "nothing is broken"}) {
    CHECK_MESSAGE(contains(outcome.output, text), text);
  }
}

TEST_CASE("doctor: --json has all findings as facts") {
  const Outcome outcome = doctor("--json", "OMP_NUM_THREADS=3 ");
  const auto json = nlohmann::json::parse(outcome.output);
  CHECK(json["sound"] == true);
  std::set<std::string> topics;
  int sound = 0, pipelines = 0, missing = 0;  // those of surfaces, in a build without satellites
  for (const auto& finding : json["findings"]) {
    if (finding["topic"] == "pipeline") {
      CHECK(finding["health"] == "missing");
      ++missing;
      continue;
    }
    topics.insert(finding["topic"].get<std::string>());
    if (finding["topic"] == "threads") CHECK(finding["facts"]["threads"] == 3);
    if (finding["topic"] == "pipelines") {
      sound = finding["facts"]["sound"];
      pipelines = finding["facts"]["pipelines"];
    }
  }
  CHECK(sound > 10);
  CHECK(sound + missing == pipelines);
#ifdef XGM_HAS_GEO
  CHECK(missing == 0);
#endif
  CHECK(topics == std::set<std::string>{"version", "opencv", "processor", "threads", "memory",
                                        "temporary files", "plugin path", "satellites", "python",
                                        "pipelines"});
}

TEST_CASE("doctor: a plugin file that does not load is named with the reason, exit 1") {
  for (const std::string arguments : {"--plugin junk.so", ""}) {
    const Outcome outcome = doctor(arguments, arguments.empty() ? "XGM_PLUGIN_PATH=junk.so " : "");
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.output, "broken   plugin file"));
    CHECK(contains(outcome.output, "junk.so: not a loadable shared object"));
    CHECK(contains(outcome.output, "broken: 1 of "));
  }
}

TEST_CASE("doctor: loaded plugin files are listed with their stages") {
  const Outcome outcome = doctor("--plugin " XGM_EXAMPLE_PLUGINS "/xgm_trim_border.so");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "xgm_trim_border.so: filter/trim_border"));
}

TEST_CASE("doctor: temporary files that have no place are told, exit 1") {
  const Outcome outcome = doctor("", "TMPDIR=/nowhere ");
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.output, "broken   temporary files"));
}
