// SPDX-License-Identifier: Apache-2.0
// File names in capitals, as cameras and other systems write them, in every layout.
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

void write_map(const std::string& file) {
  write_pfm(file, cv::Mat1f(kTreeHeight, kTreeWidth, 5.0F));
}

}  // namespace

TEST_CASE("middlebury_v3 and eth3d: names in any case") {
  const Tree tree;
  for (const std::string folder : {"v3/Desk", "eth3d/room_1l"}) {
    tree.add(folder + "/IM0.PNG");
    tree.add(folder + "/im1.Jpg");
    tree.add_text(folder + "/Calib.TXT", kCalibTxt);
    write_map(tree / (folder + "/DISP0gt.PFM"));
    tree.add(folder + "/Mask0nocc.PNG");
    const SceneFiles scene = tree.scenes(folder).at(0);
    CHECK(scene.images.left == tree / (folder + "/IM0.PNG"));
    CHECK(scene.images.right == tree / (folder + "/im1.Jpg"));
    CHECK(scene.disparities == Interval{0, 73});
    CHECK(scene.truth.non_occluded == tree / (folder + "/Mask0nocc.PNG"));
    CHECK(scene.truth.disparity.file == tree / (folder + "/DISP0gt.PFM"));
    CHECK(scene.faults.empty());
  }
}

TEST_CASE("the exact name wins; between two others there is no choice") {
  const Tree tree;
  for (const char* name : {"im0.PNG", "im0.png", "IM1.png", "Im1.png", "im0.TIF"}) tree.add(name);
  tree.add_text("CALIB.TXT", "ndisp=5\n");
  tree.add_text("calib.txt", "ndisp=6\n");
  const SceneFiles scene = tree.scenes("")[0];
  CHECK(scene.images.left == tree / "im0.png");
  CHECK(lacks(scene, "im1.png: without it the scene cannot be matched"));
  CHECK(scene.disparities == Interval{0, 6});
}

TEST_CASE("an exact ending of another format goes before a name in capitals") {
  const Tree tree;
  for (const char* name : {"im0.PNG", "im0.ppm", "im1.png"}) tree.add(name);
  CHECK(tree.scenes("")[0].images.left == tree / "im0.ppm");
}

TEST_CASE("middlebury_2001 and 2005: names in any case") {
  const Tree tree;
  for (const char* name :
       {"a/bull/IM2.PPM", "a/bull/im6.ppm", "a/bull/Disp2.PGM", "HalfSize/Aloe/View1.PNG",
        "HalfSize/Aloe/VIEW5.png", "HalfSize/Aloe/disp1.PNG"}) {
    tree.add(name);
  }
  tree.add_text("HalfSize/Aloe/DMIN.txt", "20\n");
  CHECK(tree.scenes("a")[0].truth.disparity.file == tree / "a/bull/Disp2.PGM");
  CHECK(tree.scenes("HalfSize")[0].calibration.has_value());
  CHECK(tree.scenes("HalfSize")[0].truth.disparity.file == tree / "HalfSize/Aloe/disp1.PNG");
}

TEST_CASE("kitti and sceneflow: names in any case") {
  const Tree tree;
  for (const char* name :
       {"k/Image_2/000046_10.PNG", "k/image_3/000046_10.png", "k/DISP_OCC_0/000046_10.Png"}) {
    tree.add(name);
  }
  const SceneFiles frame = tree.scenes("k").at(0);
  CHECK(frame.name == "000046_10");
  CHECK(frame.images.left == tree / "k/Image_2/000046_10.PNG");
  CHECK(frame.images.right == tree / "k/image_3/000046_10.png");
  CHECK(frame.truth.disparity.file == tree / "k/DISP_OCC_0/000046_10.Png");
  CHECK(frame.missing.size() == 3);  // disp_noc_0, obj_map, calib_cam_to_cam
  tree.add("s/Frames_Cleanpass/A/left/0006.PNG");
  tree.add("s/Frames_Cleanpass/A/RIGHT/0006.png");
  tree.add_folder("s/Disparity/a/Left");
  write_map(tree / "s/Disparity/a/Left/0006.PFM");
  const SceneFiles sequence = tree.scenes("s").at(0);
  CHECK(sequence.name == "A_0006");
  CHECK(sequence.images.right == tree / "s/Frames_Cleanpass/A/RIGHT/0006.png");
  CHECK(sequence.truth.disparity.file == tree / "s/Disparity/a/Left/0006.PFM");
}

TEST_CASE("folder: patterns and the description itself in any case") {
  const Tree tree;
  for (const char* name : {"d/Left/L_7.TIF", "d/right/R_7.tif"}) tree.add(name);
  tree.add_text("d/Dataset.YAML",
                "{type: folder, left: 'left/l_{scene}.tif', right: 'right/r_{scene}.tif'}");
  const auto scenes = tree.scenes("d");
  REQUIRE(names(scenes) == "7");
  CHECK(scenes[0].images.left == tree / "d/Left/L_7.TIF");
  CHECK(scenes[0].images.right == tree / "d/right/R_7.tif");
  CHECK(scenes[0].missing.empty());
  tree.add("d/right/r_7.tif");
  CHECK(tree.scenes("d")[0].images.right == tree / "d/right/r_7.tif");
}
