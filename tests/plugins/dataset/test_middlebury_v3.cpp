// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

void add_scene(const Tree& tree, const std::string& folder) {
  for (const char* name : {"/im0.png", "/im1.png", "/mask0nocc.png"}) tree.add(folder + name);
  tree.add(folder + "/disp0GT.pfm", 2);
  tree.add_text(folder + "/calib.txt", kCalibTxt);
}

}  // namespace

TEST_CASE("middlebury_v3: the evaluation's training set, with range, cameras, weight and scale") {
  const Tree tree;
  add_scene(tree, "trainingQ/Adirondack");
  add_scene(tree, "trainingQ/PianoL");
  tree.add("trainingQ/PianoL/disp1GT.pfm", 2);
  const auto scenes = tree.scenes("trainingQ");
  REQUIRE(names(scenes) == "Adirondack PianoL");
  const SceneFiles& scene = scenes[0];
  CHECK(scene.dataset == "middlebury_v3");
  CHECK(scene.disparities == Interval{0, 73});
  CHECK(scene.scale == 4);
  CHECK(scene.weight == 1);
  CHECK(scenes[1].weight == 0.5);
  REQUIRE(scene.calibration.has_value());
  CHECK(scene.calibration->focal == 1038.018);
  CHECK(scene.calibration->cx == 322.037);
  CHECK(scene.calibration->cy == 243.393);
  CHECK(scene.calibration->doffs == 53.271);
  CHECK(scene.calibration->baseline == 176.252);
  CHECK(scene.missing.empty());
  const GroundTruth truth = load_truth(scenes[1].truth, {kTreeWidth, kTreeHeight});
  CHECK(truth.disparity(0) == 2);
  CHECK(truth.reverse(0) == -2);
  CHECK(truth.non_occluded(0) == 9);
}

TEST_CASE("middlebury_v3: a training scene's scale follows from its width where no folder tells") {
  const Tree tree;
  add_scene(tree, "mine/Adirondack");
  CHECK(tree.scenes("mine")[0].scale == 4);
  add_scene(tree, "MiddEval3/trainingH/Adirondack");
  CHECK(tree.scenes("MiddEval3/trainingH")[0].scale == 2);
  CHECK(tree.scenes("MiddEval3/trainingH/Adirondack")[0].scale == 2);
}

TEST_CASE("middlebury_v3: exposure and lighting of the 2014 set are scenes of their own") {
  const Tree tree;
  for (const std::string folder : {"Piano-perfect", "Piano-imperfect"}) {
    for (const char* name : {"/im0.png", "/im1.png", "/im1E.png", "/im1L.png"}) {
      tree.add(folder + name);
    }
    tree.add(folder + "/disp0.pfm", 2);
    tree.add(folder + "/disp1.pfm", 2);
  }
  const auto scenes = tree.scenes();
  CHECK(names(scenes) ==
        "Piano-imperfect Piano-perfect PianoE-imperfect PianoE-perfect PianoL-imperfect "
        "PianoL-perfect");
  CHECK(scenes[3].images.right.ends_with("Piano-perfect/im1E.png"));
  CHECK(scenes[3].truth.disparity.file.ends_with("Piano-perfect/disp0.pfm"));
  CHECK(scenes[3].scale == 1);
  const SceneFiles plain = find_scene(tree / "Piano-perfect", builtins());
  CHECK(plain.name == "Piano-perfect");
  CHECK(find_scene(tree / "Piano-perfect/", builtins(), "PianoL-perfect").images.right ==
        tree / "Piano-perfect/im1L.png");
}

TEST_CASE("middlebury_v3: a bare pair is a scene that says what it lacks") {
  const Tree tree;
  tree.add("a/im0.bmp");
  tree.add("a/im1.jpg");
  const SceneFiles scene = tree.scenes("a")[0];
  CHECK(scene.name == "a");
  CHECK(lacks(scene, "calib.txt"));
  CHECK(lacks(scene, "disp0GT.pfm"));
  CHECK_FALSE(scene.disparities.has_value());
  tree.add_text("a/calib.txt", "ndisp=8\n");
  CHECK(lacks(tree.scenes("a")[0], "cam0, doffs, baseline in calib.txt"));
  CHECK(tree.scenes("a")[0].disparities == Interval{0, 8});
}

TEST_CASE("middlebury_v3: half a pair is a scene that lacks the other half, and stops no other") {
  const Tree tree;
  tree.add("a/im0.png");
  tree.add("b/im0.png");
  tree.add("b/im1.png");
  tree.add("c/im1.png");
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "a b c");
  CHECK(lacks(scenes[0], "a/im1.png: without it the scene cannot be matched"));
  CHECK_FALSE(lacks(scenes[1], "cannot be matched"));
  CHECK(lacks(scenes[2], "c/im0.png: without it the scene cannot be matched"));
}
