// SPDX-License-Identifier: Apache-2.0
// What aggregations say of their memory and work, for plans.
#include <doctest/doctest.h>

#include "plugins/aggregation/mgm/passes.hpp"
#include "plugins/aggregation/path_engine/needs.hpp"
#include "plugins/aggregation/sgm/passes.hpp"

using namespace xgm;

namespace {

Workload large(int threads) {
  Workload load = Workload::dense({2000, 1000}, 3, {0, 64});
  load.threads = threads;
  return load;
}

// Of one path: a row with a margin of 16 behind each slice.
constexpr double kRow = 2000 * (64 + 16);

}  // namespace

TEST_CASE(
    "a thread takes a whole line per path, two with 16 directions, and four lines of pixels") {
  const auto more_with_8_threads = [](const std::vector<aggregation::Pass>& passes) {
    return aggregation::needs(large(9), passes).working -
           aggregation::needs(large(1), passes).working;
  };
  // Some pixels of the other lines, and classes of penalties, are a few percent.
  for (const int directions : {4, 8, 16}) {
    CAPTURE(directions);
    const int lines = directions == 16 ? 2 : 1;
    const int paths = directions / 2;
    const double costs = lines * paths * kRow;
    const double pixels = 4 * 2000 * (3 * 4 + 1 + 4 * paths);  // an interval, a minimum per path
    const double sgm = more_with_8_threads(sgm::passes(directions));
    CHECK(sgm > 8 * (costs + pixels));
    CHECK(sgm < 1.1 * 8 * (costs + pixels));
  }
}

TEST_CASE("the classes of penalties are there for all rows in passes along columns, mgm's") {
  const double mgm = aggregation::needs(large(1), mgm::passes(8)).working;
  const double columns = 2 * 2 * 2 * 1000 * (64 + 16);  // both ways two bands, two paths
  CHECK(mgm - columns > 2 * 2 * 2e6);
  CHECK(mgm - columns < 2 * 2.4 * 2e6);
}

TEST_CASE("work is a step per cell and path, two with mgm") {
  const Workload load = large(2);
  const Needs sgm = aggregation::needs(load, sgm::passes(8));
  const Needs mgm = aggregation::needs(load, mgm::passes(16));
  CHECK(sgm.updates == 8 * load.cells());
  CHECK(mgm.updates == 32 * load.cells());
  CHECK(sgm.moved == 8 * load.cells());
  CHECK(mgm.moved == 18 * load.cells());
}
