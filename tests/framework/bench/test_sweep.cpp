// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "bench/names.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/bench.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

std::vector<std::string> names(const std::vector<SweepPoint>& points) {
  std::vector<std::string> list;
  for (const SweepPoint& point : points) list.push_back(point.name);
  return list;
}

BenchScene scene(const std::string& data_folder, const std::string& left) {
  BenchScene scene;
  scene.data_folder = data_folder;
  scene.files.images.left = left;
  return scene;
}

}  // namespace

TEST_CASE("a sweep's values end at commas, unless brackets or quotes hold them") {
  const Sweep sweep = parse_sweep("matcher.cost={type: census, window: 5},[1, 2],'a,b',7");
  CHECK(sweep.path == "matcher.cost");
  CHECK(sweep.values ==
        std::vector<std::string>{"{type: census, window: 5}", "[1, 2]", "'a,b'", "7"});
}

TEST_CASE("a sweep without path, value or difference is refused") {
  CHECK(contains(error_of([] { parse_sweep("matcher.scale"); }), "PATH=VALUE"));
  CHECK(contains(error_of([] { parse_sweep("=4,8"); }), "PATH=VALUE"));
  CHECK(contains(error_of([] { parse_sweep("matcher.scale="); }), "is empty"));
  CHECK(contains(error_of([] { parse_sweep("matcher.scale=4,,8"); }), "is empty"));
  CHECK(contains(error_of([] { parse_sweep("matcher.scale=4,8,4"); }), "4 is given twice"));
}

TEST_CASE("sweeps combine, the last changing fastest") {
  const auto points = sweep_points({{"m.scale", {"4", "8"}}, {"m.cost.window", {"5", "7"}}});
  CHECK(names(points) == std::vector<std::string>{"+scale=4+window=5", "+scale=4+window=7",
                                                  "+scale=8+window=5", "+scale=8+window=7"});
  REQUIRE(points[2].overrides.size() == 2);
  CHECK(points[2].overrides[0].path == "m.scale");
  CHECK(points[2].overrides[0].value == "8");
  CHECK(points[2].overrides[1].path == "m.cost.window");
  CHECK(points[2].overrides[1].value == "5");
}

TEST_CASE("without sweeps there is one point that changes nothing") {
  const auto points = sweep_points({});
  REQUIRE(points.size() == 1);
  CHECK(points[0].name.empty());
  CHECK(points[0].overrides.empty());
}

TEST_CASE("sweeps whose paths end alike are called by the whole path") {
  CHECK(names(sweep_points({{"a.window", {"1"}}, {"b.window", {"2"}}})) ==
        std::vector<std::string>{"+a.window=1+b.window=2"});
}

TEST_CASE("names are fit for folders, and pipelines called alike are told apart") {
  CHECK(folder_name("sgm8+cost={type: census}") == "sgm8+cost=_type__census_");
  CHECK(folder_name("../x") == ".._x");
  CHECK(folder_name("..") == "_..");
  CHECK(folder_name("") == "_");
  CHECK(folder_name(std::string(500, 'x')).size() < 200);
  std::vector<BenchPipeline> pipelines(4);
  for (auto& pipeline : pipelines) pipeline.name = "sgm8";
  pipelines[3].name = "submit";
  name_folders(pipelines);
  CHECK(pipelines[0].name == "sgm8");
  CHECK(pipelines[1].name == "sgm8-2");
  CHECK(pipelines[2].name == "sgm8-3");
  CHECK(pipelines[3].name == "submit-2");  // the folder of uploads
}

TEST_CASE("scenes given one by one are in the set of the folder around them") {
  std::vector<BenchScene> scenes{
      scene("/data/half/Teddy", "/data/half/Teddy/im0.png"),
      scene("/data/half/Teddy", "/data/half/Teddy/im0.png"),  // another right image
      scene("/data/half/Cones/", "/data/half/Cones/im0.png"),
      scene("/data/full", "/data/full/Art/im0.png"),
      scene("/other/full", "/other/full/Art/im0.png"),
      scene("/data/flat", "/data/flat/left1.png"),  // scenes beside each other
      scene("/data/flat", "/data/flat/left2.png")};
  name_sets(scenes);
  CHECK(scenes[0].set == "half");
  CHECK(scenes[1].set == "half");
  CHECK(scenes[2].set == "half");
  CHECK(scenes[3].set == "full");
  CHECK(scenes[4].set == "full-2");
  CHECK(scenes[5].set == "flat");
  CHECK(scenes[6].set == "flat");
}
