// SPDX-License-Identifier: Apache-2.0
#include "watched.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/stage/context.hpp"

namespace xgm::python {
namespace {

/// Ctrl-C and changes of the progress are noticed so often.
constexpr std::chrono::milliseconds kPeriod{50};

struct Line {
  LogLevel level;
  std::string path, text;
};

struct News {
  double share = 0;
  std::string stage;
  std::vector<Line> lines;
};

/// What the working thread tells, until the other one asks.
class Feed final : public Observer {
 public:
  void log(LogLevel level, const StagePlace& place, const std::string& text) override {
    const std::lock_guard lock(mutex_);
    news_.lines.push_back({level, place.path, text});
  }
  void stage_begin(const StagePlace& place) override {
    const std::lock_guard lock(mutex_);
    news_.stage = place.path;
  }
  void progress(double share) override {
    const std::lock_guard lock(mutex_);
    news_.share = share;
  }

  void end() {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_all();
  }
  /// Whether the work has ended; waits a period for it.
  bool wait() {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, kPeriod, [this] { return has_ended_; });
  }
  News take() {
    const std::lock_guard lock(mutex_);
    News news{news_.share, news_.stage, {}};
    news.lines.swap(news_.lines);
    return news;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  News news_;
};

const char* name_of(LogLevel level) {
  if (level == LogLevel::warning) return "warning";
  return level == LogLevel::info ? "info" : "debug";
}

/// Hands news over to Python.
class Teller {
 public:
  explicit Teller(const Hooks& hooks) : hooks_(hooks) {}

  void tell(const News& news) {
    if (!hooks_.log.is_none()) {
      for (const Line& line : news.lines) hooks_.log(name_of(line.level), line.path, line.text);
    }
    if (hooks_.progress.is_none() || (news.share == share_ && news.stage == stage_)) return;
    share_ = news.share;
    stage_ = news.stage;
    hooks_.progress(news.share, news.stage);
  }

 private:
  const Hooks& hooks_;
  double share_ = -1;
  std::string stage_;
};

bool ends_within_a_period(Feed& feed) {
  const py::gil_scoped_release release;
  return feed.wait();
}

/// Returns when the work has ended or `stop` has been asked for by a hook; throws what Python
/// raises.
void serve(const Hooks& hooks, Feed& feed, Teller& teller, std::stop_source& stop) {
  teller.tell(feed.take());
  while (!ends_within_a_period(feed)) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!hooks.cancelled.is_none() && hooks.cancelled().cast<bool>()) {
      stop.request_stop();
      return;
    }
    teller.tell(feed.take());
  }
}

/// A stage in Python that the thread is in ends at its next step; others look for themselves.
void raise_cancelled_in(unsigned long thread) {
  const py::object type = py::module_::import("xgm._errors").attr("Cancelled");
  PyThreadState_SetAsyncExc(thread, type.ptr());
}

}  // namespace

void run_watched(const Hooks& hooks, int threads,
                 const std::function<void(const RunOptions&)>& body) {
  Feed feed;
  Teller teller(hooks);
  std::stop_source stop;
  std::exception_ptr failure, interruption;
  PyObject* cause = nullptr;
  std::atomic<unsigned long> thread = 0;
  std::jthread worker([&] {
    thread = PyThread_get_thread_ident();
    try {
      body({.observer = &feed, .threads = threads, .stop = stop.get_token()});
    } catch (...) {
      failure = std::current_exception();
    }
    cause = take_cause();
    feed.end();
  });
  try {
    serve(hooks, feed, teller, stop);
  } catch (...) {
    interruption = std::current_exception();
    stop.request_stop();
  }
  if (stop.stop_requested()) raise_cancelled_in(thread);
  {
    const py::gil_scoped_release release;
    worker.join();
    if (interruption || failure) trim_heap();  // a program goes on, with other things perhaps
  }
  const py::object kept = py::reinterpret_steal<py::object>(cause);
  if (interruption) std::rethrow_exception(interruption);
  News last = feed.take();
  if (!failure) last.share = 1;
  teller.tell(last);
  if (failure) raise_in_python(failure, kept);
}

}  // namespace xgm::python
