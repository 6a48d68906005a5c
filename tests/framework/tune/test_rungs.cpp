// SPDX-License-Identifier: Apache-2.0
// How a budget of runs is spent.
#include <doctest/doctest.h>

#include "support/temporary_folder.hpp"
#include "xgm/evaluation/tune.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

TEST_CASE("tune: pipelines are halved while scenes double, to two on all scenes") {
  CHECK(plan_rungs(16, 8) == std::vector<Rung>{{16, 1}, {8, 2}, {4, 4}, {2, 8}});
  CHECK(plan_rungs(5, 11) == std::vector<Rung>{{5, 3}, {3, 6}, {2, 11}});
  CHECK(plan_rungs(2, 11) == std::vector<Rung>{{2, 11}});
  CHECK(plan_rungs(16, 3) == std::vector<Rung>{{16, 2}, {8, 3}});
  CHECK(plan_rungs(16, 1) == std::vector<Rung>{{16, 1}});
}

TEST_CASE("tune: runs of a rung that the one before has made are not counted again") {
  CHECK(runs_of(plan_rungs(16, 8)) == 16 * 1 + 8 * 1 + 4 * 2 + 2 * 4);
  CHECK(runs_of({}) == 0);
}

TEST_CASE("tune: the budget is used as far as it goes, those on scenes held back included") {
  for (std::size_t scenes = 1; scenes <= 12; ++scenes) {
    for (std::size_t budget = 2 * scenes + 4; budget < 150; ++budget) {
      const std::size_t count = affordable_pipelines(budget, scenes, 2);
      CHECK(count >= 2);
      CHECK(runs_of(plan_rungs(count, scenes)) + 4 <= budget);
      for (std::size_t more = count + 1; more <= budget; ++more) {
        CHECK(runs_of(plan_rungs(more, scenes)) + 4 > budget);
      }
    }
  }
  CHECK(contains(error_of([] { affordable_pipelines(11, 4, 2); }), "take 12 runs"));
}

TEST_CASE("tune: some scenes are held back if a share is, and never all") {
  CHECK(held_out_count(0.3, 10) == 3);
  CHECK(held_out_count(0.01, 10) == 1);
  CHECK(held_out_count(0.99, 3) == 2);
  CHECK(held_out_count(0, 10) == 0);
  CHECK(held_out_count(0.5, 1) == 0);
}
