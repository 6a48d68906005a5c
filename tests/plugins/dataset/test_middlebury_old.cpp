// SPDX-License-Identifier: Apache-2.0
// middlebury_2001 and middlebury_2005.
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

void add_2001(const Tree& tree, const std::string& folder, const std::string& ending) {
  for (int i = 0; i < 9; ++i) tree.add(folder + "/im" + std::to_string(i) + ending);
}

cv::Mat1f left_truth(const SceneFiles& scene) {
  return load_truth(scene.truth, {kTreeWidth, kTreeHeight}).disparity;
}

}  // namespace

TEST_CASE("middlebury_2001: views 2 and 6, grey levels by the scene, range by what 8 bit can say") {
  const Tree tree;
  for (const std::string scene : {"bull", "teddy", "conesH", "teddyF"}) {
    add_2001(tree, scene, ".ppm");
    tree.add(scene + "/disp2.pgm", 32);
    tree.add(scene + "/disp6.pgm", 32);
  }
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "bull conesH teddy teddyF");
  CHECK(scenes[0].dataset == "middlebury_2001");
  CHECK(scenes[0].images.left.ends_with("bull/im2.ppm"));
  CHECK(scenes[0].images.right.ends_with("bull/im6.ppm"));
  CHECK(scenes[0].disparities == Interval{0, 32});
  CHECK(scenes[2].disparities == Interval{0, 64});
  const float expected[] = {4, 16, 8, 32};
  for (std::size_t i = 0; i < scenes.size(); ++i) CHECK(left_truth(scenes[i])(0) == expected[i]);
  CHECK(load_truth(scenes[0].truth, {kTreeWidth, kTreeHeight}).reverse(0) == -4);
  CHECK(left_truth(tree.scenes("bull", "{type: middlebury_2001, divisor: 2}")[0])(0) == 16);
}

TEST_CASE("middlebury_2001: tsukuba and map have names of their own") {
  const Tree tree;
  for (int i = 1; i <= 5; ++i) {
    tree.add("set/tsukuba/scene1.row3.col" + std::to_string(i) + ".ppm");
  }
  tree.add("set/tsukuba/truedisp.row3.col3.pgm", 80);
  for (const char* name : {"im0.pgm", "im1.pgm", "disp0.pgm", "disp1.pgm"}) {
    tree.add(std::string("set/map/") + name, 80);
  }
  const auto scenes = tree.scenes("set");
  REQUIRE(names(scenes) == "map tsukuba");
  CHECK(left_truth(scenes[0])(0) == 10);
  CHECK(left_truth(scenes[1])(0) == 5);
  CHECK(scenes[1].images.right.ends_with("col4.ppm"));
  CHECK(lacks(scenes[1], "disp6"));
}

TEST_CASE("middlebury_2005: full, half and third size by the folder, dmin in px of full size") {
  const Tree tree;
  int divisor = 0;
  for (const std::string size : {"FullSize", "HalfSize", "ThirdSize"}) {
    ++divisor;
    const std::string folder = size + "/Aloe/";
    for (const char* name : {"view0.png", "view1.png", "view5.png"}) tree.add(folder + name);
    tree.add(folder + "disp1.png", 60);
    tree.add(folder + "disp5.png", 60);
    tree.add_text(folder + "dmin.txt", "270\n");
    const SceneFiles scene = tree.scenes(size)[0];
    CHECK(scene.name == "Aloe");
    CHECK(scene.dataset == "middlebury_2005");
    CHECK(left_truth(scene)(0) == 60.0f / static_cast<float>(divisor));
    CHECK(scene.disparities->end == (256 + divisor - 1) / divisor);
    CHECK(scene.scale == divisor);
    REQUIRE(scene.calibration.has_value());
    CHECK(scene.calibration->doffs == 270.0 / divisor);
    CHECK(scene.calibration->focal == 3740.0 / divisor);
    CHECK(scene.calibration->baseline == 160);
    CHECK(scene.missing.empty());
  }
}

TEST_CASE("middlebury_2005: of unknown size the truth is left out, not guessed; the height tells") {
  const Tree tree;
  tree.add("Aloe/view1.png");
  tree.add("Aloe/view5.png");
  tree.add("Aloe/disp1.png", 60);
  const SceneFiles unknown = tree.scenes()[0];
  CHECK(unknown.truth.disparity.file.empty());
  CHECK(lacks(unknown, "size"));
  const SceneFiles told = tree.scenes("Aloe", "{type: middlebury_2005, divisor: 3}")[0];
  CHECK(told.truth.disparity.divisor == 3);
  CHECK(lacks(told, "disp5.png"));
  CHECK(lacks(told, "dmin.txt"));
  write_png(tree / "Aloe/view1.png", cv::Mat1b(555, 2, 7.0));
  CHECK(tree.scenes()[0].truth.disparity.divisor == 2);
  tree.add_text("Aloe/dmin.txt", "two\n");
  CHECK(contains(faults(tree.scenes()[0]), "dmin.txt:1: dmin is \"two\""));
  CHECK_FALSE(tree.scenes()[0].calibration.has_value());
}
