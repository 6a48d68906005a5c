// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "support/support.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/tiles/tiling.hpp"

using namespace xgm;
using namespace xgm::tiles;

TEST_CASE("what a part looks at holds the partners of all that is searched, in both views") {
  xgm::testing::Random random(1);
  for (int k = 0; k < 300; ++k) {
    const cv::Size image(random.integer(1, 400), random.integer(1, 300));
    const int alignment = 1 << random.integer(0, 5), halo = random.integer(0, 40);
    const int first = random.integer(-120, 100);
    const Interval disparities{first, first + random.integer(1, 90)};
    const std::vector<cv::Rect> all = image_parts(image, {64, 64}, alignment);
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
