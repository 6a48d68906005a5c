// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/parallel.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#include "base/run_state.hpp"
#include "xgm/base/error.hpp"

namespace xgm {

int thread_count() { return omp_get_max_threads(); }

ThreadLimit::ThreadLimit(int threads) : before_(thread_count()) {
  if (threads > 0) omp_set_num_threads(threads);
}
ThreadLimit::~ThreadLimit() { omp_set_num_threads(before_); }

void parallel_for(int begin, int end, const std::function<void(int)>& body) {
  const RunState& run = run_state();
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<int> first_failure{std::numeric_limits<int>::max()};
#pragma omp parallel
  {
    const RunScope scope(run);
#pragma omp for schedule(dynamic) nowait
    for (int i = begin; i < end; ++i) {
      if (i > first_failure || run.stop.stop_requested()) continue;
      try {
        body(i);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (i < first_failure) {
          first_failure = i;
          error = std::current_exception();
        }
      }
    }
  }
  if (run.stop.stop_requested()) throw Cancelled();
  if (error) std::rethrow_exception(error);
}

namespace {

// Pixels handled between two looks at the line above: long enough to make the look cheap.
constexpr int kBlock = 64;

// How far one line has come. A cache line of its own, because its neighbours are written elsewhere.
struct alignas(64) Progress {
  std::atomic<int> done{0};
};

// Waits until `progress` has reached `pixels`. False if the run is cancelled before.
bool wait_for(const Progress& progress, int pixels, const std::stop_token& stop) {
  for (int spins = 0; progress.done.load(std::memory_order_acquire) < pixels; ++spins) {
    if (stop.stop_requested()) return false;
    if (spins > 1000) std::this_thread::yield();
  }
  return true;
}

// The lines of both fronts, dealt to threads. A front's lines are taken in order and finished in
// order, each by one thread: so all before a line are finished but those that other threads of the
// front are at. Whoever waits, waits for lines that were taken before, so that one always goes on.
class OpposedFronts {
 public:
  explicit OpposedFronts(int lines) : lines_(lines) {
    for (auto& front : progress_) front = std::vector<Progress>(static_cast<std::size_t>(lines));
  }

  // The next line: of this front, or of the other one if that has no more and a thread less than
  // it may have. False if there is none.
  bool take(int front, int max_threads, Stretch& next) {
    const std::scoped_lock lock(mutex_);
    if (taken_[front] == lines_) front = 1 - front;
    if (taken_[front] == lines_ || threads_[front] == max_threads) return false;
    const int line = taken_[front]++;
    ++threads_[front];
    next = {front, line, taken_[1 - front] <= lines_ - 1 - line, 0, 0};
    return true;
  }
  void finished(const Stretch& line) {
    const std::scoped_lock lock(mutex_);
    --threads_[line.front];
  }
  Progress& progress(int front, int line) {
    return progress_[front][static_cast<std::size_t>(line)];
  }
  Progress& progress_of_other(const Stretch& at) {
    return progress(1 - at.front, lines_ - 1 - at.line);
  }

 private:
  int lines_;
  std::mutex mutex_;
  int taken_[2] = {0, 0}, threads_[2] = {0, 0};
  std::vector<Progress> progress_[2];
};

// What a walk is called with, and the token of its run.
struct Walk {
  int length, lag;
  const std::function<void(const Stretch&)>& body;
  std::stop_token stop;
};

// Walks along the line. False if the run is cancelled before its end.
bool walk_line(OpposedFronts& fronts, Stretch& at, const Walk& walk) {
  const int length = walk.length;
  if (!at.new_line && !wait_for(fronts.progress_of_other(at), length, walk.stop)) return false;
  Progress& own = fronts.progress(at.front, at.line);
  const Progress* above = at.line > 0 ? &own - 1 : nullptr;
  for (; at.first < length; at.first = at.last) {
    at.last = std::min(length, at.first + kBlock);
    const int needed = std::min(length, at.last + walk.lag);
    if (above != nullptr && !wait_for(*above, needed, walk.stop)) return false;
    if (walk.stop.stop_requested()) return false;
    walk.body(at);
    own.done.store(at.last, std::memory_order_release);
  }
  return true;
}

}  // namespace

void opposed_wavefronts(int lines, int length, int lag,
                        const std::function<void(const Stretch&)>& body) {
  if (lines <= 0 || length <= 0) return;
  const RunState& run = run_state();
  const Walk walk{length, lag, body, run.stop};
  OpposedFronts fronts(lines);
#pragma omp parallel
  {
    const RunScope scope(run);
    Stretch at{};
    // A cancelled run stays so: all threads come to know of it, and none waits for another.
    while (fronts.take(omp_get_thread_num() % 2, omp_get_num_threads() / 2 + 1, at)) {
      if (!walk_line(fronts, at, walk)) break;
      fronts.finished(at);
    }
  }
  if (run.stop.stop_requested()) throw Cancelled();
}

}  // namespace xgm
