// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"
#include "xgm/synthesis/plain_scene.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::builtins;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void write_pair(const TemporaryFolder& folder) {
  write_png(folder / "im0.png", cv::Mat1b(4, 6, 10));
  write_png(folder / "im1.png", cv::Mat1b(4, 6, 20));
}

}  // namespace

TEST_CASE("a scene folder: images, [0, ndisp) of calib.txt, and what was read") {
  const TemporaryFolder folder;
  write_pair(folder);
  folder.write("calib.txt", "cam0=[1 0 2; 0 1 3; 0 0 1]\r\ndoffs=0\r\n ndisp = 70 \r\nvmax=65\r\n");
  const SceneFiles files = find_scene(folder.path(), builtins());
  CHECK(files.disparities == Interval{0, 70});
  const Scene scene = load_scene(files);
  CHECK(scene.pair.size() == cv::Size(6, 4));
  CHECK(scene.pair.match.planes[0](0) == 20);
  REQUIRE(scene.inputs.size() == 3);
  CHECK(scene.inputs[0].role == "left");
  CHECK(scene.inputs[2].role == "calibration");
  CHECK(scene.inputs[0].identity.fnv1a64 != scene.inputs[1].identity.fnv1a64);
}

TEST_CASE("calib.txt may be missing or without ndisp, but a faulty ndisp is located and not used") {
  const TemporaryFolder folder;
  write_pair(folder);
  CHECK_FALSE(find_scene(folder.path(), builtins()).disparities.has_value());
  folder.write("calib.txt", "baseline=60\nwidth=941\n");
  CHECK_FALSE(find_scene(folder.path(), builtins()).disparities.has_value());
  for (const char* value : {"", "0", "-4", "12px", "99999999999", "1e9", "nan", "inf"}) {
    CAPTURE(value);
    folder.write("calib.txt", std::string("width=6\nndisp=") + value + "\n");
    const SceneFiles scene = find_scene(folder.path(), builtins());
    CHECK_FALSE(scene.disparities);
    CHECK(contains(fault_of(scene, scene.calibration_file), "calib.txt:2: ndisp"));
  }
}

TEST_CASE("folders without a pair are errors with a remedy") {
  const TemporaryFolder folder;
  CHECK(contains(error_of([&] { find_scene(folder / "none", builtins()); }), "no such folder"));
  CHECK(contains(error_of([&] { find_scene(folder.path(), builtins()); }), "im0 and im1"));
  write_png(folder / "im0.png", cv::Mat1b(4, 6, 10));
  const std::vector<std::string> missing = find_scene(folder.path(), builtins()).missing;
  CHECK(contains(missing.back(), "im1.png: without it the scene cannot be matched"));
  CHECK(contains(error_of([&] { find_scene(folder / "im0.png", builtins()); }), "is a file"));
}

TEST_CASE("range maps: [floor(min), ceil(max)] with both ends, empty where not finite or crossed") {
  const TemporaryFolder folder;
  write_pfm(folder / "min.pfm", (cv::Mat1f(1, 5) << -2.5f, 3, kNan, 4, 7));
  write_pfm(folder / "max.pfm", (cv::Mat1f(1, 5) << -1.5f, 3, 5, kNan, 6));
  const DisparityRange range = read_range_maps(folder / "min.pfm", folder / "max.pfm").value;
  CHECK(range.at(0, 0) == Interval{-3, 0});
  CHECK(range.at(0, 1) == Interval{3, 4});
  for (int x = 2; x < 5; ++x) CHECK(range.at(0, x).empty());
  CHECK(range.hull() == Interval{-3, 4});
}

TEST_CASE("range maps of different size, without any range, or with nonsense are errors") {
  const TemporaryFolder folder;
  write_pfm(folder / "a.pfm", cv::Mat1f(1, 2, 5.0f));
  write_pfm(folder / "b.pfm", cv::Mat1f(2, 2, 5.0f));
  write_pfm(folder / "low.pfm", cv::Mat1f(1, 2, 1.0f));
  write_pfm(folder / "huge.pfm", cv::Mat1f(1, 2, 3e9f));
  const auto message = [&](const char* low, const char* high) {
    return error_of([&] { read_range_maps(folder / low, folder / high); });
  };
  CHECK(contains(message("a.pfm", "b.pfm"), "b.pfm: is 2 x 2 pixels"));
  CHECK(contains(message("a.pfm", "low.pfm"), "is the smallest given first?"));
  CHECK(contains(message("a.pfm", "huge.pfm"), "leaves no disparity"));
}

TEST_CASE("clip_to_width keeps what an image can show") {
  CHECK(clip_to_width({0, 70}, 741) == Interval{0, 70});
  CHECK(clip_to_width({-100, 100}, 10) == Interval{-9, 10});
  CHECK(clip_to_width({0, 5}, 1) == Interval{0, 1});
  CHECK(clip_to_width({10, 12}, 10).empty());
  CHECK(clip_to_width({-12, -9}, 10).empty());
}

TEST_CASE("the sample pair's truth lies in its range") {
  const Scene scene = synthesis::sample_scene();
  REQUIRE(scene.disparities.has_value());
  REQUIRE(scene.truth.disparity.size() == scene.pair.size());
  double low = 0, high = 0;
  cv::minMaxLoc(scene.truth.disparity, &low, &high);
  CHECK(low >= scene.disparities->begin);
  CHECK(high <= scene.disparities->end - 1);
}
