// SPDX-License-Identifier: Apache-2.0
// calib.txt: what is taken, and what is refused with its place.
#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

SceneFiles scene_with(const std::string& calib) {
  const Tree tree;
  tree.add("im0.png");
  tree.add("im1.png");
  tree.add_text("calib.txt", calib);
  return tree.scenes()[0];
}

/// The usual file with one part replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kCalibTxt;
  const std::size_t begin = text.find(from);
  REQUIRE(begin != std::string::npos);
  return text.replace(begin, from.size(), to);
}

void check_fault(const std::string& from, const std::string& to, const std::string& message) {
  const SceneFiles scene = scene_with(changed(from, to));
  CHECK_MESSAGE(contains(faults(scene), message), faults(scene));
  REQUIRE(scene.faults.size() == 1);
  CHECK(scene.faults[0].file == scene.calibration_file);
  CHECK_FALSE(scene.calibration.has_value());
  CHECK_FALSE(scene.disparities.has_value());
}

void check_taken(const std::string& calib) {
  const SceneFiles scene = scene_with(calib);
  CHECK(faults(scene) == "");
  REQUIRE(scene.calibration.has_value());
  CHECK(scene.calibration->focal == 1038.018);
  CHECK(scene.calibration->baseline == 176.252);
  CHECK(scene.disparities == Interval{0, 73});
  CHECK(scene.disparities_file == scene.calibration_file);
  CHECK(scene.calibrated_size == cv::Size(718, 496));
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t i = text.find(from); i != std::string::npos;
       i = text.find(from, i + to.size())) {
    text.replace(i, from.size(), to);
  }
  return text;
}

}  // namespace

TEST_CASE("calib.txt: its faults have file and line") {
  check_fault("[1038.018 0 322.037;", "[1038.018 0 322.037 7;", "calib.txt:1: cam0");
  check_fault("[1038.018 0 322.037;", "[1038.018 1 322.037;", "calib.txt:1: cam0");
  check_fault("[1038.018", "[-1", "calib.txt:1: cam0");
  check_fault("[1038.018", "[0", "calib.txt:1: cam0");
  check_fault("[1038.018", "[nan", "calib.txt:1: cam0 is \"nan\"");
  check_fault("53.271", "35.271", "calib.txt:3: doffs is 35.271 but cx of cam1");
  check_fault("baseline=176.252", "baseline=0", "calib.txt:4: baseline");
  check_fault("baseline=176.252", "baseline=-176.252", "calib.txt:4: baseline");
  check_fault("baseline=176.252", "baseline=inf", "calib.txt:4: baseline");
  check_fault("baseline=176.252", "baseline=", "calib.txt:4: baseline");
  check_fault("width=718", "width=718.5", "calib.txt:5: width");
  check_fault("height=496", "height=-496", "calib.txt:6: height");
  check_fault("ndisp=73", "ndisp=0", "calib.txt:7: ndisp");
  check_fault("ndisp=73", "ndisp=7.5", "calib.txt:7: ndisp");
  check_fault("isint=0", "doffs=53.271", "calib.txt:8: doffs appears twice");
}

TEST_CASE("calib.txt: decimals with a comma are told to want a point") {
  check_fault("53.271", "53,271",
              "calib.txt:3: doffs is \"53,271\"; it must be a number, with a point");
  check_fault("[1038.018 0", "[1038,018 0",
              "calib.txt:1: cam0 is \"1038,018\"; it must be a number, ");
}

TEST_CASE("calib.txt: cameras of a rectified pair have one focal length and one row") {
  const std::string cam1 = "[1038.018 0 375.308; 0 1038.018 243.393;";
  check_fault(cam1, "[1000 0 375.308; 0 1000 243.393;",
              "calib.txt:2: the focal length of cam1 is 1000 but that of cam0 is 1038.018");
  check_fault(cam1, "[1038.018 0 375.308; 0 1038.018 250;",
              "calib.txt:2: cy of cam1 is 250 but that of cam0 is 243.393");
  check_taken(changed(cam1, "[1038.02 0 375.31; 0 1038.02 243.4;"));  // rounded otherwise
}

TEST_CASE("calib.txt: byte order mark, line ends and blanks of other systems mean nothing") {
  check_taken(kCalibTxt);
  check_taken("\xEF\xBB\xBF" + kCalibTxt);
  check_taken(replace_all(kCalibTxt, "\n", "\r\n"));
  check_taken(replace_all(kCalibTxt, "\n", "\r"));
  check_taken(replace_all(kCalibTxt, "=", " = \t"));
  check_taken(changed("isint=0", "isint=maybe"));
  const std::string in_windows = replace_all(changed("ndisp=73", "ndisp=x"), "\n", "\r\n");
  CHECK(contains(faults(scene_with(in_windows)), "calib.txt:7: ndisp"));
}

TEST_CASE("calib.txt: what is no text at all is told") {
  CHECK(contains(faults(scene_with("")), "calib.txt: is empty"));
  CHECK(contains(faults(scene_with("\n \n")), "calib.txt: is empty"));
  CHECK(contains(faults(scene_with(std::string("\xFF\xFEn\0d\0", 6))), "zero bytes, as UTF-16"));
}

TEST_CASE("calib.txt: keys that are not there are named") {
  const SceneFiles bare = scene_with("isint=0\n");
  CHECK(faults(bare) == "");
  CHECK(lacks(bare, "ndisp in calib.txt"));
  CHECK(lacks(bare, "cam0, doffs, baseline in calib.txt"));
  const SceneFiles unsized_scene = scene_with(changed("width=718\nheight=496\n", ""));
  CHECK(unsized_scene.calibration.has_value());
  CHECK(unsized_scene.calibrated_size == cv::Size());
  CHECK(lacks(unsized_scene, "width, height in calib.txt"));
  CHECK(scene_with(changed("height=496\n", "")).calibrated_size == cv::Size(718, 0));
}
