// SPDX-License-Identifier: Apache-2.0
// third_party_notes names every plugin beside the publication that it comes from.
#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "support/paths.hpp"
#include "support/support.hpp"

TEST_CASE("every plugin of the library is named in third_party_notes/algorithms.md") {
  std::ifstream file(XGM_SOURCE_DIR "/third_party_notes/algorithms.md");
  std::stringstream notes;
  notes << file.rdbuf();
  REQUIRE(notes.str().find("# Algorithms") == 0);
  for (const xgm::PluginInfo* plugin : xgm::testing::builtins().plugins()) {
    CHECK_MESSAGE(notes.str().find("`" + plugin->name + "`") != std::string::npos, plugin->kind,
                  " ", plugin->name);
  }
}
