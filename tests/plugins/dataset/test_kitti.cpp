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

TEST_CASE("kitti: faults are named") {
  const Tree tree;
  add_2015(tree, "t");
  tree.add_text("t/calib_cam_to_cam/000046.txt", "P_rect_02: 1 2 3\n");
  CHECK(contains(tree.error("t"), "000046.txt:1: P_rect_02 must be 12 numbers"));
  tree.add_text("t/calib_cam_to_cam/000046.txt", "P_rect_02: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  CHECK(contains(tree.error("t"), "neither P3 nor P_rect_03"));
  tree.add_text("t/calib_cam_to_cam/000046.txt",
                "P2: 1 0 0 0 0 1 0 0 0 0 1 0\nP3: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  CHECK(contains(tree.error("t"), "000046.txt:2: is not the camera to the right"));
  std::filesystem::remove(tree / "t/image_3/000046_10.png");
  std::filesystem::remove(tree / "t/calib_cam_to_cam/000046.txt");
  CHECK(lacks(tree.scenes("t").at(0), "image_3/000046_10.png: without it"));
}
