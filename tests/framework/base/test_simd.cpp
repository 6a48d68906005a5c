// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "support/temporary_folder.hpp"
#include "xgm/base/simd.hpp"

using namespace xgm;

TEST_CASE(
    "every SIMD target of this processor can be chosen, and the best one is chosen by itself") {
  const std::vector<std::string> targets = simd_targets();
  REQUIRE_FALSE(targets.empty());
  CHECK(targets.back() == "scalar");
  CHECK(simd_target() == targets.front());
  for (const std::string& target : targets) {
    use_simd(target);
    CHECK(simd_target() == target);
  }
  use_simd("");
  CHECK(simd_target() == targets.front());
}

TEST_CASE("a SIMD target that this processor lacks is refused by name") {
  const std::string message = xgm::testing::error_of([] { use_simd("avx1024"); });
  CHECK(xgm::testing::contains(message, "avx1024"));
  CHECK(xgm::testing::contains(message, "scalar"));
  CHECK(simd_target() == simd_targets().front());
}
