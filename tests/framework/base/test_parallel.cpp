// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <vector>

#include "support/support.hpp"
#include "xgm/base/parallel.hpp"

using namespace xgm;

TEST_CASE("parallel_for visits each index once and reports the first failure") {
  for (const int threads : {1, 2, 3, 8}) {
    const xgm::ThreadLimit guard(threads);
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(0, 1000, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
    for (const auto& count : visits) REQUIRE(count == 1);
    CHECK_THROWS_WITH_AS(parallel_for(0, 100,
                                      [](int i) {
                                        if (i >= 7) throw Error("at " + std::to_string(i));
                                      }),
                         "at 7", Error);
    parallel_for(5, 5, [](int) { FAIL("nothing to visit"); });
  }
}

TEST_CASE("wavefront keeps every line behind the one above by the lag, and covers all pixels") {
  for (const int threads : {1, 2, 3, 8}) {
    const xgm::ThreadLimit guard(threads);
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(1000, 37), cv::Size(3, 100), cv::Size(64, 2)}) {
      constexpr int kLag = 5;
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(size.height));
      std::atomic<int> violations{0};
      wavefront(size.height, size.width, kLag, [&](int line, int first, int last) {
        const auto reached = [&](int back, int pixel) {
          return line < back ||
                 done[static_cast<std::size_t>(line - back)] >= std::min(pixel, size.width);
        };
        auto& own = done[static_cast<std::size_t>(line)];
        if (own != first || !reached(1, last + kLag) || !reached(2, last + 2 * kLag)) ++violations;
        if (!reached(threads, size.width)) ++violations;
        own = last;
      });
      CHECK(violations == 0);
      for (const auto& end : done) CHECK(end == size.width);
    }
  }
  wavefront(0, 10, 1, [](int, int, int) { FAIL("no lines"); });
  wavefront(10, 0, 1, [](int, int, int) { FAIL("no pixels"); });
}
