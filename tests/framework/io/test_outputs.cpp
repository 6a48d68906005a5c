// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/outputs.hpp"

#include <doctest/doctest.h>

#include "support/support.hpp"

using namespace xgm;

namespace {

DisparityMap ramp(cv::Size size) {
  DisparityMap map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) map.set(y, x, static_cast<float>(x));
  }
  return map;
}

}  // namespace

TEST_CASE("disparity picture: pixel for pixel at the top left, black exactly where there is none") {
  DisparityMap map = ramp({200, 40});
  map.invalidate(3, 5, Status::occluded);
  const cv::Mat3b picture = disparity_picture(map);
  CHECK(picture.cols >= 200);
  CHECK(picture.rows > 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 200; ++x) {
      CHECK((picture(y, x) == cv::Vec3b()) == (y == 3 && x == 5));
    }
  }
  CHECK(picture(0, 10)[0] > picture(0, 10)[2]);    // far: blue
  CHECK(picture(0, 190)[2] > picture(0, 190)[0]);  // near: red
}

TEST_CASE("pictures of any size can be made: 1 x 1, empty of disparities, all equal, large") {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3000, 2), cv::Size(2, 900)}) {
    CHECK(disparity_picture(DisparityMap(size)).rows > size.height);
    CHECK(status_picture(DisparityMap(size)).rows > size.height);
    DisparityMap flat(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) flat.set(y, x, -3.5f);
    }
    CHECK(disparity_picture(flat).cols >= size.width);
  }
}

TEST_CASE("pictures of very large maps are smaller than the maps, and so are their legends") {
  for (const cv::Size size : {cv::Size(70000, 3), cv::Size(3, 70000), cv::Size(1 << 20, 1)}) {
    CAPTURE(size.width);
    DisparityMap map(size);
    map.disparity.setTo(5);
    map.status.setTo(static_cast<int>(Status::matched));
    for (const cv::Mat3b& picture : {disparity_picture(map), status_picture(map)}) {
      CHECK(std::max(picture.cols, picture.rows) <= Sampling::kMaxSide + 200);
      CHECK(picture.total() <= 16'384 * 400);
      CHECK(picture(0, 0) != cv::Vec3b());
    }
    CHECK(picture(Image(map.disparity), Sampling::of_picture(size))(0, 0) == cv::Vec3b(5, 5, 5));
  }
}

TEST_CASE("a legend grows with the picture, but not beyond the height of a strip") {
  const auto legend = [](cv::Size size) {
    return status_picture(DisparityMap(size)).rows - size.height;
  };
  const int small = legend({400, 300});
  CHECK(legend({1600, 1200}) == 2 * small);
  CHECK(legend({8000, 6000}) == 10 * small);
  CHECK(legend({8000, 4}) == small);
  CHECK(legend({8000, 3 * small}) == 3 * small);
}

TEST_CASE("samples lie in the middle of what they stand for, within the limits of area and sides") {
  const Sampling all = Sampling::within({7, 5}, 35);
  CHECK(all.stride == 1);
  CHECK(all.at(6, 4) == cv::Point(6, 4));
  const Sampling some = Sampling::within({7, 5}, 6);
  CHECK(some.stride == 3);
  CHECK(some.shown() == cv::Size(3, 2));
  CHECK(some.at(0, 0) == cv::Point(1, 1));
  CHECK(some.at(2, 1) == cv::Point(6, 4));
  CHECK(Sampling::within({7, 5}, 0).shown() == cv::Size(1, 1));
  CHECK(Sampling::within({100000, 1}, 1e6).shown() == cv::Size(100000 / 7 + 1, 1));
}

TEST_CASE("a smaller picture shows means of blocks, in which masked pixels are black") {
  Image image(cv::Mat1f((cv::Mat1f(2, 3) << 10, 20, 99, 30, 40, 1)));
  image.valid = (cv::Mat1b(2, 3) << 255, 255, 255, 255, 0, 255);
  const cv::Mat3b shown = picture(image, Sampling{image.size(), 2});
  REQUIRE(shown.size() == cv::Size(2, 1));
  CHECK(shown(0, 0) == cv::Vec3b(15, 15, 15));
  CHECK(shown(0, 1) == cv::Vec3b(50, 50, 50));
}

TEST_CASE("status picture: one colour per status; shares add up to one") {
  DisparityMap map({kStatusCount, 2});
  for (int x = 0; x < kStatusCount; ++x) map.status.col(x) = static_cast<uchar>(x);
  const cv::Mat3b picture = status_picture(map);
  for (int a = 0; a < kStatusCount; ++a) {
    for (int b = a + 1; b < kStatusCount; ++b) CHECK(picture(0, a) != picture(0, b));
  }
  double sum = 0;
  for (const double share : status_shares(map)) {
    CHECK(share == doctest::Approx(1.0 / kStatusCount));
    sum += share;
  }
  CHECK(sum == doctest::Approx(1));
}

TEST_CASE("picture of an image: grey levels rounded and bounded, no data black") {
  Image image(cv::Mat1f((cv::Mat1f(1, 4) << 10.4f, 300, -5, 77)));
  image.valid = (cv::Mat1b(1, 4) << 255, 255, 255, 0);
  const cv::Mat3b result = picture(image);
  CHECK(result(0, 0) == cv::Vec3b(10, 10, 10));
  CHECK(result(0, 1) == cv::Vec3b(255, 255, 255));
  CHECK(result(0, 2) == cv::Vec3b());
  CHECK(result(0, 3) == cv::Vec3b());
}
