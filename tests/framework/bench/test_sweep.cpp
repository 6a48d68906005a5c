// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench.hpp"

using namespace xgm;
using xgm::testing::builtins;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

std::vector<std::string> names(const std::vector<SweepPoint>& points) {
  std::vector<std::string> list;
  for (const SweepPoint& point : points) list.push_back(point.name);
  return list;
}

/// A folder that a data set takes for a scene; nothing opens its images.
void add_scene(const TemporaryFolder& folder, const std::string& name) {
  std::filesystem::create_directories(folder / name);
  for (const char* image : {"/im0.png", "/im1.png"}) folder.write(name + image, "image");
}

std::vector<std::string> sets_of(const std::vector<BenchScene>& scenes) {
  std::vector<std::string> list;
  for (const BenchScene& scene : scenes) list.push_back(scene.set + ": " + scene.files.name);
  return list;
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

TEST_CASE("a parameter is swept once") {
  CHECK(contains(error_of([] {
                   sweep_points({{"m.scale", {"4"}}, {"m.scale", {"8"}}});
                 }),
                 "m.scale: is given twice"));
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
  std::vector<BenchPipeline> pipelines;
  for (const std::string& name :
       {std::string("sgm8"), std::string("sgm8"), std::string("sgm8+cost={type: census}"),
        std::string("../x"), std::string(".."), std::string(), std::string("submit"),
        std::string(500, 'x')}) {
    pipelines.emplace_back().name = name;
  }
  name_folders(pipelines);
  CHECK(pipelines[0].name == "sgm8");
  CHECK(pipelines[1].name == "sgm8-2");
  CHECK(pipelines[2].name == "sgm8+cost=_type__census_");
  CHECK(pipelines[3].name == ".._x");
  CHECK(pipelines[4].name == "_..");
  CHECK(pipelines[5].name == "_");
  CHECK(pipelines[6].name == "submit-2");  // beside the folder of uploads
  CHECK(pipelines[7].name.size() < 200);
}

TEST_CASE("scenes whose names differ never share a folder") {
  BenchRequest request{.output = "out", .pipelines = {{}}, .scenes = {}};
  request.pipelines[0].name = "sgm8";
  for (const std::string& name : {std::string("a_b"), std::string("a b"), std::string("a/b"),
                                  std::string(300, 'x'), std::string(301, 'x')}) {
    BenchScene& scene = request.scenes.emplace_back();
    scene.set = "set";
    scene.files.name = name;
  }
  std::set<std::string> folders;
  for (std::size_t i = 0; i < request.scenes.size(); ++i)
    folders.insert(cell_folder(request, 0, i));
  CHECK(folders.size() == request.scenes.size());
  CHECK(folders.contains("out/sgm8/set/a_b"));
}

TEST_CASE("scenes given one by one are in the set of the folder around them") {
  const TemporaryFolder folder;
  for (const char* name : {"half/Teddy", "half/Cones", "full/Art", "other/full/Art"}) {
    add_scene(folder, name);
  }
  folder.write("half/Teddy/im1E.png", "image");  // another right image
  const auto scenes = find_bench_scenes({folder / "half/Teddy", folder / "half/Cones/",
                                         folder / "full", folder / "other/full", folder / "full"},
                                        builtins(), "", {});
  CHECK(sets_of(scenes) == std::vector<std::string>{"half: Teddy", "half: TeddyE", "half: Cones",
                                                    "full: Art", "full-2: Art"});
}

TEST_CASE("scenes are picked by name") {
  const TemporaryFolder folder;
  for (const char* name : {"half/Teddy", "half/Cones"}) add_scene(folder, name);
  const auto scenes = find_bench_scenes({folder / "half"}, builtins(), "", {"Teddy"});
  CHECK(sets_of(scenes) == std::vector<std::string>{"half: Teddy"});
  const std::string error =
      error_of([&] { find_bench_scenes({folder / "half"}, builtins(), "", {"Tedy"}); });
  CHECK(contains(error, "did you mean 'Teddy'"));
}
