// SPDX-License-Identifier: Apache-2.0
// What a surface takes, predicted and taken.
#include <cmath>

#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/base/json.hpp"
#include "xgm/geo/synthesis/plan_views.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;

namespace {

void check_plan(const SatelliteDesk& desk, const std::string& arguments, double windows) {
  CAPTURE(arguments);
  const Outcome planned = desk.call("plan " + arguments + " --json");
  CAPTURE(planned.errors);
  REQUIRE(planned.exit_code == 0);
  const Outcome made = desk.call("run " + arguments + " -o out");
  CAPTURE(made.errors);
  REQUIRE(made.exit_code == 0);
  const Json plan = Json::parse(planned.output);
  const Json record = Json::parse(read_file(desk / "out/run.json"));
  CHECK(plan.at("windows").number() == windows);
  CHECK(plan.at("pairs").number() == static_cast<double>(record.at("pairs").size()));
  CHECK(plan.at("matching_seconds").number() > 0);
  CHECK(plan.at("largest_window").at("stages").size() > 3);
#ifndef XGM_SANITIZED  // sanitizers need memory of their own
  const double peak = record.at("peak_memory_bytes").number();
  CAPTURE(peak);
  CAPTURE(plan.at("peak_bytes").number());
  CHECK(std::abs(plan.at("peak_bytes").number() / peak - 1) < 0.15);
#endif
}

}  // namespace

TEST_CASE("the memory of surfaces is as planned: one window, and several of several pairs") {
  const SatelliteDesk desk;
  SatelliteSceneSpec spec;
  spec.size = 500;
  spec.relief = 20;
  spec.views = plan_views({.images = 3, .dates = 1, .incidence = 9}, spec.seed);
  write_satellite_scene(desk / "three", make_satellite_scene(spec));
  check_plan(desk, "dsm_tsgm8 --images three/image_1.tif three/image_2.tif --dem three/dem.tif", 1);
  check_plan(desk, "dsm_tsgm8 three/scene.yaml --set tile=260 --set matching=sgm8", 12);
}

TEST_CASE("a plan of a surface for people, and what it refuses") {
  const SatelliteDesk desk;
  const std::string images = "--images scene/image_1.tif scene/image_2.tif ";
  const Outcome planned = desk.call("plan dsm_tsgm8 " + images);
  CAPTURE(planned.errors);
  CHECK(planned.exit_code == 0);
  CHECK(contains(planned.output, "1 pair in 1 window"));
  CHECK(contains(planned.output, "memory: "));
  const auto error = [&](const std::string& arguments) {
    const Outcome outcome = desk.call("plan " + arguments);
    CAPTURE(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output.empty());
    return outcome.errors;
  };
  CHECK(contains(error("dsm_tsgm8 --size 100x100 --disparities 0:9"), "--size: is for pairs"));
  CHECK(contains(error("sgm8 " + images), "type surface"));
  CHECK(contains(error("dsm_tsgm8 --images scene/image_1.tif none.tif"), "none.tif"));
}
