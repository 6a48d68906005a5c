// SPDX-License-Identifier: Apache-2.0
// The source tree keeps the rules. That the rules notice planted violations is tested beside.
#include <doctest/doctest.h>

#include "architecture/rules.hpp"
#include "architecture/told.hpp"
#include "support/paths.hpp"

using namespace xgm::architecture;

namespace {

const Tree& sources() {
  static const Tree tree = read_tree(XGM_SOURCE_DIR);
  return tree;
}

}  // namespace

TEST_CASE("architecture: the sources are found") {
  CHECK(sources().contains("framework/core/include/xgm/pipeline.hpp"));
  CHECK(sources().contains("plugins/cost/census/census.cpp"));
  CHECK(sources().contains("tests/architecture/rules.hpp"));
  CHECK(sources().size() > 300);
}

TEST_CASE("architecture: no include points up or across") {
  CHECK(told(forbidden_includes(sources())) == "");
}

TEST_CASE("architecture: there is no include cycle") {
  CHECK(told(include_cycles(sources())) == "");
}

TEST_CASE("architecture: there is no cycle between folders") {
  CHECK(told(folder_cycles(sources())) == "");
}

TEST_CASE("architecture: public headers show matrices with their type of elements") {
  CHECK(told(untyped_matrices(sources())) == "");
}

TEST_CASE("architecture: every source begins with its licence") {
  CHECK(told(missing_licences(sources())) == "");
}

TEST_CASE("architecture: no file is longer than 400 lines") {
  CHECK(told(long_files(sources())) == "");
}

TEST_CASE("architecture: no function is longer than 60 lines") {
  CHECK(told(long_functions(sources())) == "");
}
