// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

TEST_CASE("folder: patterns of folders or of files, with all that can be said of a scene") {
  const Tree tree;
  for (const std::string scene : {"one", "two"}) {
    tree.add("data/" + scene + "/im_left.png");
    tree.add("data/" + scene + "/im_right.png");
  }
  tree.add("data/one/gt.png", 60);
  tree.add("data/one/gt_right.png", 60);
  tree.add("data/notes/readme.png");
  tree.add_text("data/dataset.yaml",
                "type: folder\n"
                "left: '{scene}/im_left.png'\n"
                "right: '{scene}/im_right.png'\n"
                "truth: '{scene}/gt.png'\n"
                "truth_divisor: 4\n"
                "no_data: [0, -9999]\n"
                "truth_no_data: [255]\n"
                "reverse_truth: '{scene}/gt_right.png'\n"
                "reverse_truth_divisor: -4\n"
                "disparities: [-8, 40]\n"
                "weight: 0.5\n"
                "scale: 2\n");
  const auto scenes = tree.scenes("data");
  REQUIRE(names(scenes) == "one two");
  CHECK(scenes[0].dataset == "folder");
  CHECK(scenes[0].disparities == Interval{-8, 41});
  CHECK(scenes[0].weight == 0.5);
  CHECK(scenes[0].scale == 2);
  CHECK(scenes[0].images.no_data == std::vector<double>{0, -9999});
  CHECK(scenes[0].truth.disparity.no_data == std::vector<double>{255});
  CHECK(scenes[0].truth.reverse.no_data == std::vector<double>{255});
  const GroundTruth truth = load_truth(scenes[0].truth, {kTreeWidth, kTreeHeight});
  CHECK(truth.disparity(0) == 15);
  CHECK(truth.reverse(0) == -15);
  CHECK(lacks(scenes[1], "two/gt.png"));
}

TEST_CASE("folder: names may stand inside file names; without a gap the folder is one scene") {
  const Tree tree;
  tree.add("d/L_7.png");
  tree.add("d/L_8.png");
  tree.add("d/R_7.png");
  tree.add("d/R_8.png");
  CHECK(names(tree.scenes("d", "{type: folder, left: 'L_{scene}.png', right: 'R_{scene}.png'}")) ==
        "7 8");
  const auto one = tree.scenes("d", "{type: folder, left: L_7.png, right: R_8.png}");
  CHECK(names(one) == "d");
}

TEST_CASE("folder: the same name in several places is the same scene") {
  const Tree tree;
  tree.add("a/x/x_l.png");
  tree.add("a/x/x_r.png");
  tree.add("a/y/z_l.png");
  CHECK(
      names(tree.scenes(
          "a", "{type: folder, left: '{scene}/{scene}_l.png', right: '{scene}/{scene}_r.png'}")) ==
      "x");
}

TEST_CASE(
    "folder: faults of the description have file, line and remedy; lacking images are named") {
  const Tree tree;
  tree.add("d/L_7.png");
  tree.add_text("d/dataset.yaml", "type: folder\nlfet: 'L_{scene}.png'\nright: 'R_{scene}.png'\n");
  CHECK(contains(tree.error("d"),
                 "dataset.yaml:2:1: error: folder has no parameter 'lfet'; did you"));
  CHECK(contains(tree.error("d"), "'left' of folder must be given"));
  tree.add_text("d/dataset.yaml", "type: foldr\n");
  CHECK(contains(tree.error("d"), "dataset.yaml:1:7: error: there is no dataset called 'foldr'"));
  tree.add_text("d/dataset.yaml", "{type: folder, left: 'L_{scene}.png', right: R.png}\n");
  CHECK(contains(tree.error("d"), "must have '{scene}' if left has it"));
  tree.add_text("d/dataset.yaml", "{type: folder, left: '{scnee}/a', right: '{scene}/b'}\n");
  CHECK(contains(tree.error("d"), "did you mean {scene}?"));
  tree.add_text("d/dataset.yaml",
                "{type: folder, left: 'L_{scene}.png', right: 'R_{scene}.png'}\n");
  CHECK(lacks(tree.scenes("d")[0], "R_7.png: without it the scene cannot be matched"));
  tree.add_text("d/dataset.yaml",
                "{type: folder, left: 'M_{scene}.png', right: 'R_{scene}.png'}\n");
  CHECK(contains(tree.error("d"), "data set folder finds no scene here; it looks for M_"));
}

TEST_CASE("folder: whole numbers are no truth without a divisor, floats are, reverse ones turned") {
  const Tree tree;
  for (const char* name : {"d/l.png", "d/r.png", "d/t.png"}) tree.add(name, 60);
  tree.add("d/t.pfm", 7);
  const auto truth = [&](const std::string& keys) {
    const std::string yaml = "{type: folder, left: l.png, right: r.png, " + keys + "}";
    return load_truth(tree.scenes("d", yaml)[0].truth, {kTreeWidth, kTreeHeight});
  };
  for (const std::string key : {"truth", "reverse_truth"}) {
    const std::string error = error_of([&] { truth(key + ": t.png"); });
    CHECK_MESSAGE(contains(error, "t.png: holds whole numbers"), error);
    CHECK(contains(error, "truth_divisor"));
  }
  CHECK(truth("truth: t.png, truth_divisor: 4").disparity(0) == 15);
  CHECK(truth("truth: t.pfm").disparity(0) == 7);
  CHECK(truth("reverse_truth: t.pfm").reverse(0) == -7);
}
