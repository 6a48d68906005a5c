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

TEST_CASE("status picture: one colour per status; shares add up to one") {
  DisparityMap map({kStatusCount, 2});
  for (int x = 0; x < kStatusCount; ++x) map.status.col(x) = x;
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
