// SPDX-License-Identifier: Apache-2.0
// pipeline tiles, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

struct Desk : TemporaryFolder {
  Desk() {
    testing::SceneOptions options;
    options.size = {200, 130};
    options.disparities = {0, 24};
    const testing::SyntheticScene scene = testing::make_scene(options);
    write_png(*this / "left.png", picture(scene.pair.base));
    write_png(*this / "right.png", picture(scene.pair.match));
  }
  Outcome call(const std::string& arguments) const { return testing::pipeline(path(), arguments); }
};

const std::string kPair = " --left left.png --right right.png --disparities 0:23 ";

void check_refused(const Outcome& outcome, const std::string& message, int code = 2) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == code);
  CHECK(contains(outcome.errors, message));
}

}  // namespace

TEST_CASE("tiles: plan, run and join give the map of run --tiles") {
  const Desk desk;
  const Outcome plan = desk.call("tiles plan tsgm8" + kPair + "--tiles 128x96 --threads 1 -o work");
  INFO(plan.errors);
  REQUIRE(plan.exit_code == 0);
  CHECK(contains(plan.output, "work/manifest.json: 5 jobs in tiles of up to 128 x 96 px"));
  check_refused(desk.call("tiles run work/manifest.json tile_2_2"), "not done: coarse", 1);
  check_refused(desk.call("tiles join work/manifest.json"), "tile_1_1, tile_1_2", 1);
  for (const char* job : {"coarse", "tile_2_2", "tile_1_1", "tile_1_2", "tile_2_1"}) {
    CHECK(desk.call("tiles run work/manifest.json " + std::string(job)).exit_code == 0);
  }
  CHECK(contains(desk.call("tiles run work/manifest.json coarse").output, "was done before"));
  CHECK(desk.call("tiles join work/manifest.json").exit_code == 0);
  REQUIRE(desk.call("run tsgm8" + kPair + "--tiles 128x96 -o once").exit_code == 0);
  for (const char* name : {"disparity.pfm", "disparity.png", "status.png"}) {
    CAPTURE(std::string(name));
    CHECK(read_file(desk / ("work/" + std::string(name))) ==
          read_file(desk / ("once/" + std::string(name))));
  }
}

TEST_CASE(
    "tiles: what is fitted to the whole scene comes from a job, whose file is named if missing") {
  const Desk desk;
  const Outcome plan =
      desk.call("tiles plan tmgm16_refined" + kPair + "--tiles 128x96 --threads 1 -o work");
  INFO(plan.errors);
  REQUIRE(plan.exit_code == 0);
  CHECK(contains(plan.output, "6 jobs"));
  check_refused(desk.call("tiles run work/manifest.json coarse"),
                "not done: fit; work/jobs/fit.json is missing", 1);
  for (const char* job : {"fit", "coarse", "tile_2_2", "tile_1_1", "tile_1_2", "tile_2_1"}) {
    CHECK(desk.call("tiles run work/manifest.json " + std::string(job)).exit_code == 0);
  }
  CHECK(desk.call("tiles join work/manifest.json").exit_code == 0);
  REQUIRE(desk.call("run tmgm16_refined" + kPair + "--tiles 128x96 -o once").exit_code == 0);
  CHECK(read_file(desk / "work/disparity.pfm") == read_file(desk / "once/disparity.pfm"));
}

TEST_CASE("tiles: mistakes are exit 2, each with its remedy") {
  const Desk desk;
  check_refused(desk.call("tiles"), "subcommand");
  check_refused(desk.call("tiles rnu a.json b"),
                "there is no subcommand 'rnu'; did you mean 'run'?");
  check_refused(desk.call("tiles plan tsgm8 --tiels 64x64"), "did you mean '--tiles'?");
  check_refused(desk.call("tiles plan tsgm8" + kPair + "-o work"), "--memory-limit SIZE");
  check_refused(desk.call("tiles plan tsgm8 --tiles 128x96 -o work"), "jobs need images in files");
  check_refused(desk.call("tiles plan tsgm8" + kPair + "--tiles 30x30 -o work"),
                "each at least 64");
  check_refused(desk.call("tiles plan tsgm8" + kPair + "--memory-limit 20MB -o work"),
                "raise --memory-limit");
  check_refused(desk.call("tiles plan tsgm8 left.png right.png -o work"),
                "--left FILE --right FILE");
  CHECK_FALSE(std::filesystem::exists(desk / "work/manifest.json"));
  desk.write("bad.json", "{}");
  check_refused(desk.call("tiles run bad.json coarse"), "bad.json: is no manifest of jobs");
  check_refused(desk.call("tiles run none.json coarse"), "none.json");
  REQUIRE(desk.call("tiles plan sgm8" + kPair + "--tiles 128x96 -o work").exit_code == 0);
  check_refused(desk.call("tiles run work/manifest.json coarse"), "there is no job 'coarse'");
}
