// SPDX-License-Identifier: Apache-2.0
// pipeline synth --satellite and pipeline bench over its scenes, as a user meets them.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

Outcome call(const TemporaryFolder& folder, const std::string& arguments) {
  return xgm::testing::pipeline(folder.path(), arguments);
}

}  // namespace

#ifdef XGM_HAS_GEO
namespace {

const std::string kSmall =
    " --satellite --size 160 --relief 20 --dem-posting 10 --dem-error 0.5 --incidence 14";

}  // namespace

TEST_CASE("synth --satellite: the same seed, the same bytes, whatever stands before it") {
  const TemporaryFolder folder;
  const Outcome made = call(folder, "synth one --count 2 --seed 4 --threads 1" + kSmall);
  INFO(made.errors);
  REQUIRE(made.exit_code == 0);
  CHECK(contains(made.output, "one/scene_0002: seed 5, 2 images of 160 x 160 px"));
  call(folder, "synth other --seed 5 --threads 3" + kSmall);
  for (const char* name : {"image_1.tif", "image_2.tif", "dsm.tif", "dem.tif", "scene.yaml"}) {
    CAPTURE(name);
    CHECK(read_file(folder / (std::string("one/scene_0002/") + name)) ==
          read_file(folder / (std::string("other/scene_0001/") + name)));
  }
  CHECK(contains(read_file(folder / "one/scene_0001/scene.yaml"), "pointing_error"));
}

TEST_CASE("synth --satellite: mistakes are told before anything is written") {
  const TemporaryFolder folder;
  for (const auto& mistake : {std::pair<std::string, std::string>{" --size 64x48", "square"},
                              {" --relief hills.tif", "neither a number of metres nor a file"},
                              {" --images 1", "number of images is 1"},
                              {" --dates 3", "number of dates is 3"},
                              {" --sun 2", "sun_elevation is 2"},
                              {" --dem-datum moon", "moon"},
                              {" --fault blur", "--fault"}}) {
    CAPTURE(mistake.first);
    const Outcome outcome = call(folder, "synth out --satellite" + mistake.first);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, mistake.second));
  }
  CHECK(call(folder, "synth out --images 3").exit_code == 2);  // without --satellite
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("bench of surfaces: one command compares matching parts, and goes on from where it was") {
  const TemporaryFolder folder;
  REQUIRE(call(folder, "synth region --images 3" + kSmall).exit_code == 0);
  const std::string bench =
      "bench --pipelines dsm_tsgm8 --sweep matching=sgm8,tsgm8 --data region --threads 2 ";
  const Outcome outcome = call(folder, bench);
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "region: average of 3 scenes"));
  const auto json = nlohmann::json::parse(read_file(folder / "xgm_bench/bench.json"));
  REQUIRE(json["cells"].size() == 6);
  for (const auto& cell : json["cells"]) {
    CHECK(cell["state"] == "done");
    CHECK(cell["figures"]["levelled_completeness"] > 0.4);
    CHECK(cell["figures"]["disparity_total_1"] < 0.6);
    CHECK(cell["figures"]["search_px"] > 1);
  }
  CHECK(json["averages"][0]["pipeline"] == "dsm_tsgm8+matching=sgm8");
  CHECK(contains(read_file(folder / "xgm_bench/bench.md"), "rank correlation"));
  const Outcome again = call(folder, bench);
  CHECK(again.output == outcome.output);
  CHECK_FALSE(contains(again.errors, " MB"));
  const Outcome fused =
      call(folder, "bench --pipelines dsm_tsgm8 --data region --fused --output f");
  CHECK(fused.exit_code == 0);
  CHECK(contains(fused.output, "region: average of 1 scenes"));
}

TEST_CASE("bench of surfaces: mistakes are told before any run") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "empty");
  for (const auto& mistake :
       {std::pair<std::string, std::string>{"dsm_tsgm8,sgm8 --data empty", "benches of their own"},
        {"dsm_tsgm8 --data empty", "holds no satellite scene"},
        {"dsm_tsgm8 --data nowhere", "nowhere: is no folder"},
        {"dsm_tsgm8 --data empty --submit kitti", "--submit"},
        {"sgm8 --data empty --fused", "--fused"},
        {"dsm_tsgm8 --data empty --set matching=sgm9", "sgm9"}}) {
    CAPTURE(mistake.first);
    const Outcome outcome = call(folder, "bench --pipelines " + mistake.first);
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, mistake.second));
  }
}
#else
TEST_CASE("synth --satellite: a program without GDAL says so") {
  const TemporaryFolder folder;
  const Outcome outcome = call(folder, "synth out --satellite");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "built without GDAL"));
}
#endif
