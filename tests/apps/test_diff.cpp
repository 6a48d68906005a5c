// SPDX-License-Identifier: Apache-2.0
// pipeline diff, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>

#include "apps/small_scene.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SmallScene;

TEST_CASE("diff: two runs alike are exit 0, a changed parameter is exit 1 and told") {
  const SmallScene scene;
  REQUIRE(scene.call("run p.yaml scene --output a --threads 1").exit_code == 0);
  REQUIRE(scene.call("run p.yaml scene --output b --threads 2").exit_code == 0);
  REQUIRE(scene.call("run p.yaml scene --output c --set matcher.cost.window=3").exit_code == 0);
  const Outcome same = scene.call("diff a b");
  INFO(same.output, same.errors);
  CHECK(same.exit_code == 0);
  CHECK(contains(same.output, "the runs are the same"));
  const Outcome other = scene.call("diff a c");
  CHECK(other.exit_code == 1);
  CHECK(contains(other.output, "configuration:\n  matcher.cost.window: 5 -> 3\n"));
  CHECK_FALSE(contains(other.output, "inputs:"));
}

TEST_CASE("diff: --threshold and --output look at the map") {
  const SmallScene scene;
  REQUIRE(scene.call("run p.yaml scene --output a").exit_code == 0);
  std::filesystem::create_directory(scene / "moved");
  cv::Mat1f map = read_pfm(scene / "a/disparity.pfm");
  map(10, 20) += 2;
  write_pfm(scene / "moved/disparity.pfm", map);
  std::filesystem::copy_file(scene / "a/run.json", scene / "moved/run.json");
  const Outcome moved = scene.call("diff a moved --output pictures");
  INFO(moved.output, moved.errors);
  CHECK(moved.exit_code == 1);
  CHECK(contains(moved.output, "differing: 1 px (0.104 %), in x 20 to 20, y 10 to 10"));
  CHECK(std::filesystem::exists(scene / "pictures/difference.png"));
  CHECK(scene.call("diff a moved --threshold 2.5").exit_code == 0);
}

TEST_CASE("diff: what cannot be compared is exit 2") {
  const SmallScene scene;
  REQUIRE(scene.call("run p.yaml scene --output a").exit_code == 0);
  const Outcome missing = scene.call("diff a nowhere");
  CHECK(missing.exit_code == 2);
  CHECK(contains(missing.errors, "nowhere: is no folder"));
  CHECK(scene.call("diff a scene").exit_code == 2);
  CHECK(scene.call("diff a a --threshold -1").exit_code == 2);
  scene.write("file", "in the way");
  CHECK(scene.call("diff a a --output file").exit_code == 2);
}
