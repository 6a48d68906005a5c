// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/point_cloud.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Calibration kCameras{.focal = 1000, .cx = 2, .cy = 1, .doffs = 10, .baseline = 200};

}  // namespace

TEST_CASE("a point computed by hand") {
  // Z = 200 mm * 1000 px / (30 + 10) px = 5000 mm; X = (6 - 2) / 1000 * Z; Y = (0 - 1) / 1000 * Z
  const cv::Point3d point = point_of(kCameras, 6, 0, 30);
  CHECK(point.z == 5000);
  CHECK(point.x == 20);
  CHECK(point.y == -5);
  CHECK(std::isnan(point_of(kCameras, 6, 0, -10).z));
  CHECK(std::isnan(point_of(kCameras, 6, 0, -11).z));
  CHECK(std::isnan(point_of(kCameras, 6, 0, kNan).z));
  CHECK(point_of(kCameras, 6, 0, -9).z == 200000);
}

TEST_CASE("both cameras see a point where its pixel and its disparity say") {
  xgm::testing::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double x = random.real(0, 700), y = random.real(0, 500), d = random.real(-9, 200);
    const cv::Point3d p = point_of(kCameras, x, y, d);
    const double left = kCameras.focal * p.x / p.z + kCameras.cx;
    const double right =
        kCameras.focal * (p.x - kCameras.baseline) / p.z + kCameras.cx + kCameras.doffs;
    CHECK(left == doctest::Approx(x));
    CHECK(kCameras.focal * p.y / p.z + kCameras.cy == doctest::Approx(y));
    CHECK(left - right == doctest::Approx(d));
  }
}

TEST_CASE("a PLY has the points that have a depth, with the image's colours") {
  const TemporaryFolder folder;
  const cv::Mat1f map = (cv::Mat1f(1, 4) << 30, kNan, -10, 90);
  Image left;
  for (const float level : {10.0f, 20.0f, 300.0f}) left.planes.emplace_back(1, 4, level);
  CHECK(write_point_cloud(folder / "c.ply", map, kCameras, left) == 2);
  CHECK(folder.files() == 1);
  const std::string bytes = read_file(folder / "c.ply");
  const std::size_t body = bytes.find("end_header\n") + 11;
  CHECK(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
  CHECK(contains(bytes, "element vertex 2\n"));
  REQUIRE(bytes.size() == body + 2 * 15);
  float xyz[3];
  std::memcpy(xyz, bytes.data() + body + 15,
              sizeof xyz);  // the second; this machine is little-endian
  CHECK(xyz[0] == 2);       // (3 - 2) / 1000 * 2000
  CHECK(xyz[1] == -2);
  CHECK(xyz[2] == 2000);
  const auto colour = [&](std::size_t i) {
    return int{static_cast<unsigned char>(bytes[body + 15 + 12 + i])};
  };
  CHECK(colour(0) == 255);  // red, which was above white
  CHECK(colour(1) == 20);
  CHECK(colour(2) == 10);
}

TEST_CASE(
    "grey images give grey points; images of another size are an error; nothing is a cloud too") {
  const TemporaryFolder folder;
  const Image grey(cv::Mat1f(2, 1, 77.0f));
  CHECK(write_point_cloud(folder / "g.ply", cv::Mat1f(2, 1, 30.0f), kCameras, grey) == 2);
  CHECK(read_file(folder / "g.ply").ends_with("\x4d\x4d\x4d"));
  CHECK(contains(
      error_of([&] { write_point_cloud(folder / "x.ply", cv::Mat1f(3, 1, 1.0f), kCameras, grey); }),
      "is 1 x 2 pixels"));
  CHECK(write_point_cloud(folder / "n.ply", cv::Mat1f(2, 1, kNan), kCameras, grey) == 0);
  CHECK(contains(read_file(folder / "n.ply"), "element vertex 0\n"));
}

TEST_CASE("depths are read back from the TIFF bit by bit, NaN as NaN") {
  const TemporaryFolder folder;
  const cv::Mat1f map = (cv::Mat1f(2, 3) << 30, kNan, -10, 90, 0.5f, 7);
  const cv::Mat1f written = depths(map, kCameras);
  CHECK(written(0, 0) == 5000);
  CHECK(std::isnan(written(0, 1)));
  CHECK(std::isnan(written(0, 2)));
  write_depths(folder / "d.tiff", written);
  const cv::Mat read = cv::imread(folder / "d.tiff", cv::IMREAD_UNCHANGED);
  REQUIRE(read.type() == CV_32FC1);
  REQUIRE(read.size() == written.size());
  for (int y = 0; y < 2; ++y) {
    CHECK(std::memcmp(read.ptr(y), written.ptr(y), 3 * sizeof(float)) == 0);
  }
}
