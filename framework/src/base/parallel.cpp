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

namespace xgm {

int thread_count() { return omp_get_max_threads(); }

ThreadLimit::ThreadLimit(int threads) : before_(thread_count()) {
  if (threads > 0) omp_set_num_threads(threads);
}
ThreadLimit::~ThreadLimit() { omp_set_num_threads(before_); }

void parallel_for(int begin, int end, const std::function<void(int)>& body) {
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<int> first_failure{std::numeric_limits<int>::max()};
#pragma omp parallel for schedule(dynamic)
  for (int i = begin; i < end; ++i) {
    if (i > first_failure) continue;
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
  if (error) std::rethrow_exception(error);
}

namespace {

// Pixels handled between two looks at the line above: long enough to make the look cheap.
constexpr int kBlock = 64;

// How far one line has come. A cache line of its own, because its neighbours are written elsewhere.
struct alignas(64) Progress {
  std::atomic<int> done{0};
};

// Waits until `progress` has reached `pixels`.
void wait_for(const Progress& progress, int pixels) {
  for (int spins = 0; progress.done.load(std::memory_order_acquire) < pixels; ++spins) {
    if (spins > 1000) std::this_thread::yield();
  }
}

}  // namespace

void wavefront(int lines, int length, int lag,
               const std::function<void(int line, int first, int last)>& body) {
  if (lines <= 0 || length <= 0) return;
  std::vector<Progress> progress(static_cast<std::size_t>(lines));
#pragma omp parallel
  {
    // Lines are dealt in turn, so a thread's own line - thread_count is finished before its next
    // one starts, and by the waits below everything above that line is, too.
    const int step = omp_get_num_threads();
    for (int line = omp_get_thread_num(); line < lines; line += step) {
      Progress& own = progress[static_cast<std::size_t>(line)];
      const Progress* above = line > 0 ? &own - 1 : nullptr;
      for (int first = 0; first < length; first += kBlock) {
        const int last = std::min(length, first + kBlock);
        if (above != nullptr) wait_for(*above, std::min(length, last + lag));
        body(line, first, last);
        own.done.store(last, std::memory_order_release);
      }
    }
  }
}

}  // namespace xgm
