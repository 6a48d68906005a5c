// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "support/temporary_folder.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/simd.hpp"

using namespace xgm;

TEST_CASE(
    "every SIMD target of this processor can be chosen, and the best one is chosen by itself") {
  const std::vector<std::string> targets = simd_targets();
  REQUIRE_FALSE(targets.empty());
  CHECK(targets.back() == "scalar");
  CHECK(simd_target() == targets.front());
  for (const std::string& target : targets) {
    const SimdChoice choice(target);
    CHECK(simd_target() == target);
  }
  CHECK(simd_target() == targets.front());
}

TEST_CASE("a SIMD target that this processor lacks is refused by name") {
  const std::string message = xgm::testing::error_of([] { const SimdChoice choice("avx1024"); });
  CHECK(xgm::testing::contains(message, "avx1024"));
  CHECK(xgm::testing::contains(message, "scalar"));
  CHECK(xgm::testing::contains(message, simd_targets().front()));
  CHECK(simd_target() == simd_targets().front());
}

TEST_CASE("choices of a SIMD target nest, and an empty one changes nothing") {
  const SimdChoice outer("scalar");
  {
    const SimdChoice inner(simd_targets().front());
    CHECK(simd_target() == simd_targets().front());
    const SimdChoice none("");
    CHECK(simd_target() == simd_targets().front());
  }
  CHECK(simd_target() == "scalar");
}

TEST_CASE("a SIMD target holds for the threads of loops, and for no others") {
  const std::string best = simd_targets().front();
  const ThreadLimit threads(4);
  std::atomic<int> wrong{0};
  const auto check = [&](const std::string& expected) {
    parallel_for(0, 50, [&](int) { wrong += simd_target() != expected; });
    opposed_wavefronts(20, 200, 1, [&](const Stretch&) { wrong += simd_target() != expected; });
  };
  {
    const SimdChoice choice("scalar");
    check("scalar");
    std::thread([&] { check(best); }).join();
    check("scalar");
  }
  check(best);
  CHECK(wrong == 0);
}

TEST_CASE("a SIMD target chosen within a loop is that of this call alone") {
  const ThreadLimit threads(4);
  const SimdChoice scalar("scalar");
  const std::string best = simd_targets().front();
  std::atomic<int> wrong{0};
  parallel_for(0, 200, [&](int i) {
    if (i % 2 == 0) {
      const SimdChoice choice(best);
      wrong += simd_target() != best;
    } else {
      wrong += simd_target() != "scalar";
    }
  });
  CHECK(wrong == 0);
}
