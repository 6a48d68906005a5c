// SPDX-License-Identifier: Apache-2.0
// Which data set a folder is, which scene is meant, and what is true of it.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void add_pair(const Tree& tree, const std::string& folder) {
  tree.add(folder + "/im0.png");
  tree.add(folder + "/im1.png");
}

}  // namespace

TEST_CASE("what nobody recognises is told with all that was looked for") {
  const Tree tree;
  tree.add("photo.png");
  const std::string error = tree.error();
  for (const char* part :
       {"middlebury_v3: im0 and im1", "view1 and view5", "\n  kitti: ", "dataset.yaml"}) {
    CHECK_MESSAGE(contains(error, part), error);
  }
}

TEST_CASE("what several recognise needs --dataset") {
  const Tree tree;
  add_pair(tree, "a");
  tree.add("b/view1.png");
  tree.add("b/view5.png");
  CHECK(contains(tree.error(), "any of the data sets middlebury_2005, middlebury_v3"));
  CHECK(names(tree.scenes(".", "middlebury_v3")) == "a");
  CHECK(names(tree.scenes(".", "{type: middlebury_2005}")) == "b");
}

TEST_CASE("a data set may be named, written as YAML, or in a file; faults are told") {
  const Tree tree;
  add_pair(tree, "a");
  const std::string file = tree.write("my.yaml", "type: middlebury_v3\n");
  CHECK(names(tree.scenes("a", file)) == "a");
  CHECK(contains(tree.error("a", "midlebury_v3"), "did you mean 'middlebury_v3'?"));
  CHECK(contains(tree.error("a", "nofile.yaml"), "nofile.yaml: no such file"));
  CHECK(contains(tree.error("a", "census"), "is a cost, not a dataset"));
  CHECK(contains(tree.error("a", "folder"), "'left' of folder must be given"));
  CHECK(contains(tree.error("a", "kitti"),
                 "data set kitti finds no scene here; it looks for image_2"));
}

TEST_CASE("a description that says nothing is told by the name of its file") {
  const Tree tree;
  add_pair(tree, "a");
  for (const char* text : {"\n", "# to be written\n", "---\n"}) {
    const std::string file = tree.write("empty.yaml", text);
    const std::string error = tree.error("a", file);
    CHECK_MESSAGE(error.starts_with(file), error);
    CHECK_MESSAGE(contains(error, "expected a dataset, found nothing"), error);
  }
}

TEST_CASE("one of several scenes is named; a miss is answered with the nearest name") {
  const Tree tree;
  add_pair(tree, "Piano");
  add_pair(tree, "Pipes");
  const auto error = [&](const std::string& name) {
    return error_of([&] { find_scene(tree.path(), builtins(), name); });
  };
  CHECK(find_scene(tree.path(), builtins(), "Pipes").name == "Pipes");
  CHECK(contains(error(""), "holds 2 scenes; choose one with --scene NAME: Piano, Pipes"));
  CHECK(contains(error("Pino"), "did you mean 'Piano'?"));
  CHECK(contains(error("unlike any"), "scenes: Piano, Pipes"));
}

TEST_CASE("truth of another size than the images is an error that names the file") {
  const Tree tree;
  tree.add("t.pfm", 2);
  TruthFiles files;
  files.disparity.file = tree / "t.pfm";
  CHECK(load_truth(files, {kTreeWidth, kTreeHeight}).non_occluded.empty());
  CHECK(contains(error_of([&] { load_truth(files, {9, 9}); }), "t.pfm: is 4 x 3 pixels but"));
  CHECK(load_truth({}, {9, 9}).disparity.empty());
}

TEST_CASE("cross_check: within 1 px is seen, else hidden; no truth is neither") {
  const cv::Mat1f left = (cv::Mat1f(1, 6) << 0, 2, 1, kNan, 2.25f, 1);
  const cv::Mat1f right = (cv::Mat1f(1, 6) << 0, -2.5f, -1.4f, 0, -2.1f, 0);
  // x - d: 0, -1 (outside), 1, -, 1.75 -> 2, 4
  const cv::Mat1b mask = cross_check(left, right);
  const int expected[] = {255, 128, 128, 0, 255, 128};
  for (int x = 0; x < 6; ++x) CHECK_MESSAGE(int{mask(0, x)} == expected[x], "column ", x);
  const cv::Mat1f half = (cv::Mat1f(1, 2) << kNan, 0.5f), there = (cv::Mat1f(1, 2) << -0.5f, 9);
  CHECK(int{cross_check(half, there)(0, 1)} == 255);  // column 0.5 is 0
  CHECK_FALSE(error_of([&] { cross_check(left, cv::Mat1f(2, 6)); }).empty());
}

TEST_CASE("scenes as JSON: numbers where they are known, null where not") {
  const Tree tree;
  add_pair(tree, "a");
  tree.add_text("a/calib.txt", kCalibTxt);
  const auto json = nlohmann::json::parse(to_json(tree.scenes("a")));
  REQUIRE(json.size() == 1);
  CHECK(json[0]["name"] == "a");
  CHECK(json[0]["disparities"]["last"] == 72);
  CHECK(json[0]["calibration"]["baseline_mm"] == 176.252);
  CHECK(json[0]["truth"].is_null());
  CHECK(json[0]["missing"].size() == 1);
}
