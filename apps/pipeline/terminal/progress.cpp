// SPDX-License-Identifier: Apache-2.0
#include "terminal/progress.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "terminal/console.hpp"

namespace xgm::cli {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kTerminalPeriod{0.2};
constexpr Seconds kPlainPeriod{1.0};
// Before that, an estimate would be a guess.
constexpr double kMinShare = 0.02;
constexpr double kMinSeconds = 0.5;

}  // namespace

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 100) return std::to_string(whole) + " s";
  const long minutes = std::lround(seconds / 60);
  return minutes < 100 ? std::to_string(minutes) + " min" : fmt::format("{:.1f} h", seconds / 3600);
}

Progress::Progress() : thread_([this] { work(); }) {}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stop_signal_.notify_one();
  thread_.join();
  end();
}

void Progress::begin(const std::string& what) {
  const std::lock_guard lock(mutex_);
  what_ = what;
  stage_.clear();
  share_ = 0;
  start_ = Clock::now();
}

void Progress::end() {
  const std::lock_guard lock(mutex_);  // held while a line is drawn: none comes after this
  what_.clear();
  Console::instance().status("");
}

void Progress::stage(const std::string& path) {
  const std::lock_guard lock(mutex_);
  stage_ = path;
}

void Progress::share(double share) {
  const std::lock_guard lock(mutex_);
  share_ = share;
}

std::string Progress::line() const {
  const double elapsed = Seconds(Clock::now() - start_).count();
  std::string text = what_;
  if (share_ > 0) text += fmt::format(" {:3.0f} %", 100 * share_);
  text += ", " + duration_text(elapsed);
  if (share_ > kMinShare && elapsed > kMinSeconds) {
    text += ", about " + duration_text(elapsed * (1 - share_) / share_) + " left";
  }
  if (!stage_.empty()) text += ": " + stage_;
  return text;
}

void Progress::work() {
  const bool rewrites = Console::instance().rewrites();
  std::unique_lock lock(mutex_);
  while (!stop_signal_.wait_for(lock, rewrites ? kTerminalPeriod : kPlainPeriod,
                                [this] { return stop_; })) {
    if (what_.empty()) continue;
    if (rewrites) {
      if (shows_info()) Console::instance().status(line());
    } else {
      log_info(line());
    }
  }
}

}  // namespace xgm::cli
