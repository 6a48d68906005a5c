// SPDX-License-Identifier: Apache-2.0
// Runs doctest. Exits with 77 ("skipped") when every test that ran asked for real data that is not
// there.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "support/support.hpp"

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  context.setOption("no-path-filenames", true);
  const int result = context.run();
  if (context.shouldExit() || result != 0) return result;
  return xgm::testing::was_skipped() ? 77 : 0;
}
