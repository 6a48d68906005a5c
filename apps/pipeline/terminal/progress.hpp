// SPDX-License-Identifier: Apache-2.0
// Tells the user where a run stands, however long one of its stages takes.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace xgm::cli {

/// "40 s", "7 min", "2.5 h"
std::string duration_text(double seconds);

/// A thread of its own shows the state: on a terminal one line several times a second, elsewhere a
/// log message every second.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A new part of the run ("reading the images"); its time starts now.
  void begin(const std::string& what);
  /// Nothing more to show, until the next begin().
  void end();
  /// What is being worked on within it.
  void stage(const std::string& path);
  /// How much of it is done, 0 to 1; the time left is estimated from it.
  void share(double share);

 private:
  using Clock = std::chrono::steady_clock;

  void work();
  std::string line() const;

  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stop_ = false;
  std::string what_, stage_;
  double share_ = 0;
  Clock::time_point start_ = Clock::now();
  std::thread thread_;
};

}  // namespace xgm::cli
