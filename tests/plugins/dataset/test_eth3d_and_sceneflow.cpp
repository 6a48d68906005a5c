// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

TEST_CASE("eth3d: told from Middlebury by the names, a mixed folder is no longer ETH3D's") {
  const Tree tree;
  for (const std::string scene : {"delivery_area_1l", "playground_2s"}) {
    for (const char* name : {"/im0.png", "/im1.png", "/mask0nocc.png", "/disp0GT.pfm"}) {
      tree.add(scene + name);
    }
    tree.add_text(scene + "/calib.txt", kCalibTxt);
  }
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "delivery_area_1l playground_2s");
  CHECK(scenes[0].dataset == "eth3d");
  CHECK(scenes[0].weight == 1);
  CHECK(scenes[0].missing.empty());
  CHECK(scenes[0].disparities == Interval{0, 73});
  CHECK(tree.scenes("playground_2s")[0].dataset == "eth3d");
  tree.add("Teddy/im0.png");
  tree.add("Teddy/im1.png");
  CHECK(tree.scenes()[0].dataset == "middlebury_v3");
  CHECK(names(tree.scenes()) == "Teddy delivery_area_1l playground_2s");
}

TEST_CASE("sceneflow: the tree of images is repeated below disparity; right truth is turned") {
  const Tree tree;
  for (const std::string sequence : {"TRAIN/A/0000", "TRAIN/B/0001"}) {
    for (const std::string view : {"left", "right"}) {
      tree.add("frames_cleanpass/" + sequence + "/" + view + "/0006.png");
      tree.add("frames_finalpass/" + sequence + "/" + view + "/0006.png");
      if (sequence == "TRAIN/A/0000") {
        tree.add("disparity/" + sequence + "/" + view + "/0006.pfm", 5);
      }
    }
  }
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "TRAIN_A_0000_0006 TRAIN_B_0001_0006");
  CHECK(scenes[0].dataset == "sceneflow");
  CHECK(contains(scenes[0].images.left, "frames_cleanpass/TRAIN/A/0000/left/0006.png"));
  const GroundTruth truth = load_truth(scenes[0].truth, {kTreeWidth, kTreeHeight});
  CHECK(truth.disparity(0) == 5);
  CHECK(truth.reverse(0) == -5);
  CHECK(scenes[0].missing.empty());
  CHECK(lacks(scenes[1], "left/0006.pfm"));
  const auto blurred = tree.scenes(".", "{type: sceneflow, pass: final}");
  CHECK(contains(blurred[0].images.left, "frames_finalpass"));
  std::filesystem::remove_all(tree / "frames_cleanpass");
  CHECK(contains(tree.error(), "has frames_finalpass only"));
  std::filesystem::remove(tree / "frames_finalpass/TRAIN/A/0000/right/0006.png");
  CHECK(lacks(tree.scenes(".", "{type: sceneflow, pass: final}")[0], "0006.png: without it"));
}
