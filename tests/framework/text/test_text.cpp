// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "xgm/base/shell.hpp"
#include "xgm/base/text.hpp"

using namespace xgm;

TEST_CASE("the shortest text of a number gives it back, and is plain where people read it") {
  CHECK(short_number(0.5) == "0.5");
  CHECK(short_number(100000) == "100000");
  CHECK(short_number(-0.05) == "-0.05");
  const double largest = std::numeric_limits<double>::max();
  for (const double value : {0.1, 1.0 / 3, 123456789012345.6, 1e-300, -largest}) {
    CHECK(std::stod(short_number(value)) == value);
  }
}

TEST_CASE("numbers of so many decimals have no signed zero") {
  CHECK(fixed_number(2.0 / 3, 2) == "0.67");
  CHECK(fixed_number(-0.001, 2) == "0.00");
  CHECK(fixed_number(-0.006, 2) == "-0.01");
  CHECK(fixed_number(12, 0) == "12");
  CHECK(fixed_number(std::numeric_limits<double>::max(), 2).size() == 312);
}

TEST_CASE("words are quoted for a shell if they need it") {
  CHECK(shell_word("out/a+b=1") == "out/a+b=1");
  CHECK(shell_word("") == "''");
  CHECK(shell_word("a b") == "'a b'");
  CHECK(shell_word("it's") == "'it'\\''s'");
  CHECK(shell_word("$(x)") == "'$(x)'");
}
