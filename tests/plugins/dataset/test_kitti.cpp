// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

// P_rect_02 and P_rect_03 as the benchmark's files have them: metres times pixels in column 4.
const std::string kProjections =
    "calib_time: 09-Jan-2012 13:57:47\n"
    "P_rect_02: 7.215377e+02 0 6.095593e+02 4.485728e+01 0 7.215377e+02 1.728540e+02 2.163791e-01 "
    "0 0 1 2.745884e-03\n"
    "P_rect_03: 7.215377e+02 0 6.095593e+02 -3.395242e+02 0 7.215377e+02 1.728540e+02 2.199936e+00 "
    "0 0 1 2.729905e-03\n";

void write_16_bit(const std::string& file, const cv::Mat_<std::uint16_t>& values) {
  std::ofstream stream(file, std::ios::binary);  // a PGM, which is told by its content
  stream << "P5\n" << values.cols << ' ' << values.rows << "\n65535\n";
  for (const std::uint16_t value : values) {
    stream.put(static_cast<char>(value >> 8)).put(static_cast<char>(value & 255));
  }
}

void add_2015(const Tree& tree, const std::string& top) {
  for (const char* frame : {"/000046_10.png", "/000046_11.png"}) {
    tree.add(top + "/image_2" + frame);
    tree.add(top + "/image_3" + frame);
  }
  for (const char* folder : {"/disp_occ_0", "/disp_noc_0", "/obj_map"}) {
    tree.add(top + folder + "/000046_10.png", 0);
  }
  cv::Mat_<std::uint16_t> values(kTreeHeight, kTreeWidth, std::uint16_t{640});
  values(0, 0) = 0;
  write_16_bit(tree / (top + "/disp_occ_0/000046_10.png"), values);
  values(0, 1) = 0;
  write_16_bit(tree / (top + "/disp_noc_0/000046_10.png"), values);
  tree.add_text(top + "/calib_cam_to_cam/000046.txt", kProjections);
}

}  // namespace

TEST_CASE("kitti: 2015, its first frames only; what only disp_occ has is occluded") {
  const Tree tree;
  add_2015(tree, "set/training");
  for (const char* folder : {"set", "set/training"}) {
    const auto scenes = tree.scenes(folder);
    REQUIRE(names(scenes) == "000046_10");
    CHECK(scenes[0].dataset == "kitti");
    CHECK(scenes[0].missing.empty());
    CHECK(scenes[0].disparities == Interval{0, 256});
    const GroundTruth truth = load_truth(scenes[0].truth, {kTreeWidth, kTreeHeight});
    CHECK(std::isnan(truth.disparity(0, 0)));
    CHECK(truth.disparity(0, 1) == 2.5f);
    CHECK(truth.non_occluded(0, 0) == 0);
    CHECK(truth.non_occluded(0, 1) == 128);
    CHECK(truth.non_occluded(0, 2) == 255);
    CHECK(truth.objects(0, 0) == 0);
    const Calibration& cameras = scenes[0].calibration.value();
    CHECK(cameras.focal == 721.5377);
    CHECK(cameras.doffs == 0);
    CHECK(cameras.baseline == doctest::Approx(1000 * (44.85728 + 339.5242) / 721.5377));
  }
}

TEST_CASE("kitti: 2012 in grey or in colour; test scenes lack their truth") {
  const Tree tree;
  for (const char* folder : {"image_0", "image_1", "colored_0", "colored_1"}) {
    tree.add("testing/" + std::string(folder) + "/000000_10.png");
  }
  const SceneFiles grey = tree.scenes("testing")[0];
  CHECK(contains(grey.images.left, "image_0"));
  CHECK(lacks(grey, "disp_occ:"));
  CHECK(lacks(grey, "disp_noc:"));
  CHECK(lacks(grey, "calib:"));
  CHECK_FALSE(lacks(grey, "obj_map"));
  const SceneFiles colour = tree.scenes("testing", "{type: kitti, images: colour}")[0];
  CHECK(contains(colour.images.right, "colored_1"));
}

TEST_CASE("kitti: the size of the images stands beside the cameras of 2015") {
  const Tree tree;
  add_2015(tree, "t");
  CHECK(tree.scenes("t")[0].calibrated_size == cv::Size());
  tree.add_text("t/calib_cam_to_cam/000046.txt",
                "S_rect_02: 1.242000e+03 3.750000e+02\r\n" + kProjections);
  const SceneFiles scene = tree.scenes("t")[0];
  CHECK(scene.calibrated_size == cv::Size(1242, 375));
  CHECK(scene.calibration.has_value());
  CHECK(scene.disparities_file == "");  // the benchmark's range holds for any size
}

TEST_CASE("kitti: faults of a calibration are the scene's, with file and line") {
  const Tree tree;
  add_2015(tree, "t");
  const auto check = [&](const std::string& text, const std::string& message) {
    tree.add_text("t/calib_cam_to_cam/000046.txt", text);
    const SceneFiles scene = tree.scenes("t").at(0);
    CHECK_MESSAGE(contains(faults(scene), message), faults(scene));
    CHECK_FALSE(scene.calibration.has_value());
    CHECK(scene.disparities == Interval{0, 256});
  };
  const std::string p2 = "P2: 1 0 0 0 0 1 0 0 0 0 1 0\n";
  check("P_rect_02: 1 2 3\n", "000046.txt:1: P_rect_02 must be 12 numbers");
  check("P_rect_02: nan 0 0 0 0 1 0 0 0 0 1 0\n", "000046.txt:1: P_rect_02 is \"nan\"");
  check("P_rect_02: 1,5 0 0 0 0 1 0 0 0 0 1 0\n", "with a point before its decimals");
  check("P_rect_02: 1 0 0 0 0 1 0 0 0 0 1 0\n", "neither P3 nor P_rect_03");
  check(p2 + "P3: 1 0 0 0 0 1 0 0 0 0 1 0\n", "000046.txt:2: is not the camera to the right");
  check(p2 + "P3: 2 0 0 -9 0 2 0 0 0 0 1 0\n",
        "000046.txt:2: the focal length of P3 is 2 but that of P2 is 1");
  check(p2 + "P3: 1 0 0 -9 0 1 7 0 0 0 1 0\n", "000046.txt:2: cy of P3 is 7");
  check(p2 + "P3: 1 0.5 0 -9 0 1 0 0 0 0 1 0\n", "000046.txt:2: P3 is no projection");
  check(p2 + p2, "000046.txt:2: P2 appears twice");
  check("S_rect_02: 12\n" + kProjections, "000046.txt:1: S_rect_02 must be width and height");
}

TEST_CASE("kitti: a frame of which one image is there lacks the other") {
  const Tree tree;
  add_2015(tree, "t");
  tree.add("t/image_2/000047_10.png");
  tree.add("t/image_3/000048_10.png");
  const auto scenes = tree.scenes("t");
  REQUIRE(names(scenes) == "000046_10 000047_10 000048_10");
  CHECK(lacks(scenes[1], "image_3/000047_10.png: without it"));
  CHECK(lacks(scenes[2], "image_2/000048_10.png: without it"));
}
