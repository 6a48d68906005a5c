// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "support/support.hpp"
#include "xgm/tiles/tiling.hpp"

using namespace xgm;
using namespace xgm::tiles;

TEST_CASE("the parts of the map cover it once, none larger than asked for") {
  for (const cv::Size image : {cv::Size(1, 1), cv::Size(7, 300), cv::Size(1000, 641)}) {
    for (const cv::Size size : {cv::Size(64, 64), cv::Size(100, 333), cv::Size(5000, 5000)}) {
      for (const int alignment : {1, 8, 32}) {
        CAPTURE(image);
        CAPTURE(size);
        CAPTURE(alignment);
        cv::Mat1i covered(image, 0);
        for (const cv::Rect& core : cores(image, size, alignment)) {
          CHECK(core.width <= size.width);
          CHECK(core.height <= size.height);
          CHECK(core.x % alignment == 0);
          CHECK(core.y % alignment == 0);
          covered(core) += 1;
        }
        CHECK(cv::countNonZero(covered == 1) == image.area());
      }
    }
  }
}

TEST_CASE("what a part looks at holds the partners of all that is searched, in both views") {
  xgm::testing::Random random(1);
  for (int k = 0; k < 300; ++k) {
    const cv::Size image(random.integer(1, 400), random.integer(1, 300));
    const int alignment = 1 << random.integer(0, 5), halo = random.integer(0, 40);
    const int first = random.integer(-120, 100);
    const Interval disparities{first, first + random.integer(1, 90)};
    const std::vector<cv::Rect> all = cores(image, {64, 64}, alignment);
    const cv::Rect core = all[random.next() % all.size()];
    const Surroundings around = surroundings(core, halo, disparities, image, alignment);
    const cv::Rect whole({}, image), window = around.window;
    CHECK((window & whole) == window);
    CHECK((around.searched & window) == around.searched);
    CHECK((around.reverse_searched & window) == around.reverse_searched);
    CHECK((around.searched & core) == core);
    const bool left = window.x % alignment == 0 && window.y % alignment == 0;
    CHECK(left);
    const bool right = window.br().x % alignment == 0 || window.br().x == image.width;
    CHECK(right);
    for (const int x : {around.searched.x, around.searched.br().x - 1}) {
      for (const int d : {disparities.begin, disparities.end - 1}) {
        const cv::Point seen(x - d, core.y);
        if (whole.contains(seen)) CHECK(around.reverse_searched.contains(seen));
      }
    }
    if (around.reverse_searched.empty()) continue;
    for (const int x : {around.reverse_searched.x, around.reverse_searched.br().x - 1}) {
      for (const int d : {disparities.begin, disparities.end - 1}) {
        const cv::Point seen(x + d, core.y);
        if (whole.contains(seen)) CHECK(window.contains(seen));
      }
    }
  }
}
