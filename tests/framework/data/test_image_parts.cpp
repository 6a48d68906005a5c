// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "support/support.hpp"
#include "xgm/data/image_parts.hpp"

using namespace xgm;

TEST_CASE("parts of an image cover it once, none larger than asked for") {
  for (const cv::Size image : {cv::Size(1, 1), cv::Size(7, 300), cv::Size(1000, 641)}) {
    for (const cv::Size size : {cv::Size(64, 64), cv::Size(100, 333), cv::Size(5000, 5000)}) {
      for (const int alignment : {1, 8, 32}) {
        CAPTURE(image);
        CAPTURE(size);
        CAPTURE(alignment);
        cv::Mat1i covered(image, 0);
        for (const cv::Rect& part : image_parts(image, size, alignment)) {
          CHECK(part.width <= size.width);
          CHECK(part.height <= size.height);
          CHECK(part.x % alignment == 0);
          CHECK(part.y % alignment == 0);
          covered(part) += 1;
        }
        CHECK(cv::countNonZero(covered == 1) == image.area());
      }
    }
  }
}
