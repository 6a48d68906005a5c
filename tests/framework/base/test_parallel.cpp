// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <chrono>
#include <stop_token>
#include <thread>
#include <vector>

#include "base/run_state.hpp"
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

namespace {

// What both fronts have done, and whether all was there that they may rely on.
struct Fronts {
  static constexpr int kLag = 5;
  const int lines, length, threads;
  std::vector<std::atomic<int>> done[2] = {
      std::vector<std::atomic<int>>(static_cast<std::size_t>(lines)),
      std::vector<std::atomic<int>>(static_cast<std::size_t>(lines))};
  std::atomic<int> violations{0};

  std::atomic<int>& at(int front, int line) { return done[front][static_cast<std::size_t>(line)]; }

  void visit(const Stretch& s) {
    const auto reached = [&](int back, int pixel) {
      return s.line < back || at(s.front, s.line - back) >= std::min(pixel, length);
    };
    auto& own = at(s.front, s.line);
    if (own != s.first || !reached(1, s.last + kLag) || !reached(2, s.last + 2 * kLag))
      ++violations;
    if (!reached(threads / 2 + 1, length)) ++violations;
    const int other = at(1 - s.front, lines - 1 - s.line);
    if (other != (s.new_line ? 0 : length)) ++violations;
    own = s.last;
  }
};

}  // namespace

TEST_CASE("opposed_wavefronts cover all pixels twice, lines behind each other, none at once") {
  for (const int threads : {1, 2, 3, 8}) {
    const xgm::ThreadLimit guard(threads);
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(1000, 37), cv::Size(3, 100), cv::Size(64, 2)}) {
      CAPTURE(threads);
      CAPTURE(size.height);
      Fronts fronts{size.height, size.width, threads};
      std::atomic<int> new_lines{0};
      opposed_wavefronts(size.height, size.width, Fronts::kLag, [&](const Stretch& stretch) {
        if (stretch.first == 0 && stretch.new_line) ++new_lines;
        fronts.visit(stretch);
      });
      CHECK(fronts.violations == 0);
      CHECK(new_lines == size.height);
      for (const auto& front : fronts.done)
        for (const auto& end : front) CHECK(end == size.width);
    }
  }
  opposed_wavefronts(0, 10, 1, [](const Stretch&) { FAIL("no lines"); });
  opposed_wavefronts(10, 0, 1, [](const Stretch&) { FAIL("no pixels"); });
}

TEST_CASE("two threads have a front each, until they have met") {
  const xgm::ThreadLimit guard(2);
  // Each front waits at its first line for the other one to be there, too: alone, it would wait
  // long.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  std::atomic<int> begun{0}, met{0};
  opposed_wavefronts(10, 10, 1, [&](const Stretch& stretch) {
    if (stretch.line > 0 || stretch.first > 0 || !stretch.new_line) return;
    ++begun;
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    if (begun == 2) ++met;
  });
  CHECK(met == 2);
}

namespace {

/// While it lives, this thread's run can be cancelled.
struct StoppableRun {
  std::stop_source stop;
  RunChange change{RunState{.stop = stop.get_token()}};
};

}  // namespace

TEST_CASE("parallel_for ends with Cancelled and begins nothing more when its run is cancelled") {
  for (const int threads : {1, 2, 3, 8}) {
    const xgm::ThreadLimit guard(threads);
    StoppableRun run;
    std::atomic<int> calls{0};
    const auto body = [&](int i) {
      ++calls;
      if (i == 5) run.stop.request_stop();
      if (i > 5) throw Error("cancelling goes before failures");
    };
    CHECK_THROWS_AS(parallel_for(0, 1000, body), Cancelled);
    CHECK(calls < 6 + threads);
    calls = 0;
    CHECK_THROWS_AS(parallel_for(0, 1000, body), Cancelled);
    CHECK(calls == 0);
    std::thread([] {
      std::atomic<int> others{0};
      parallel_for(0, 100, [&](int) { ++others; });
      CHECK(others == 100);
    }).join();
  }
}

TEST_CASE("a loop within a loop hears that the run is cancelled") {
  const xgm::ThreadLimit guard(3);
  StoppableRun run;
  std::atomic<int> finished{0};
  CHECK_THROWS_AS(parallel_for(0, 3,
                               [&](int) {
                                 parallel_for(0, 10, [&](int) { run.stop.request_stop(); });
                                 ++finished;
                               }),
                  Cancelled);
  CHECK(finished == 0);
}

TEST_CASE("opposed_wavefronts end with Cancelled wherever they are, and no thread waits for ever") {
  for (const int threads : {1, 2, 3, 8}) {
    const xgm::ThreadLimit guard(threads);
    constexpr int kLines = 12, kLength = 300, kStretches = 2 * kLines * 5;
    for (int last = 1; last < kStretches; last += 7) {
      CAPTURE(threads);
      CAPTURE(last);
      StoppableRun run;
      std::atomic<int> calls{0};
      CHECK_THROWS_AS(opposed_wavefronts(kLines, kLength, 5,
                                         [&](const Stretch&) {
                                           if (++calls == last) run.stop.request_stop();
                                         }),
                      Cancelled);
      CHECK(calls < last + threads);
    }
  }
}

TEST_CASE("opposed_wavefronts end when another thread cancels while they wait for each other") {
  const xgm::ThreadLimit guard(4);
  StoppableRun run;
  std::atomic<bool> begun{false};
  std::thread other([&] {
    while (!begun) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    run.stop.request_stop();
  });
  // The first lines never come to an end by themselves.
  const auto body = [&](const Stretch& stretch) {
    begun = true;
    if (stretch.line == 0) {
      while (!run.stop.stop_requested()) std::this_thread::yield();
    }
  };
  CHECK_THROWS_AS(opposed_wavefronts(10, 1000, 5, body), Cancelled);
  other.join();
}
