// SPDX-License-Identifier: Apache-2.0
// Reports the progress of parallel work, and carries its exceptions to the calling thread.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "xgm/stage/context.hpp"

namespace xgm::aggregation {

/// Counts the lines that all threads have finished. Observers may be called from the thread that
/// runs the pipeline only. That thread works on lines like the others, and reports the count after
/// each of its own lines.
class LineProgress {
 public:
  LineProgress(Context context, int lines) : context_(std::move(context)), lines_(lines) {}

  void lines_finished(int count) {
    const int finished = finished_ += count;
    if (std::this_thread::get_id() == home_) context_.progress(double(finished) / lines_);
  }

 private:
  Context context_;
  int lines_;
  std::atomic<int> finished_ = 0;
  std::thread::id home_ = std::this_thread::get_id();
};

/// Runs pieces of work in a place that exceptions must not leave. Keeps the first exception and
/// skips all work after it.
class ExceptionKeeper {
 public:
  template <class Work>
  void run(Work&& work) noexcept {
    if (failed_) return;
    try {
      std::forward<Work>(work)();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
};

}  // namespace xgm::aggregation
