// SPDX-License-Identifier: Apache-2.0
#include "terminal/console.hpp"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

namespace xgm::cli {
namespace {

constexpr const char* kEraseLine = "\r\033[K";

std::size_t terminal_width() {
  winsize size{};
  constexpr std::size_t kUsual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

class ConsoleSink final : public spdlog::sinks::base_sink<std::mutex> {
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    std::string line(text.data(), text.size());
    while (line.ends_with('\n')) line.pop_back();
    Console::instance().message(line);
  }
  void flush_() override {}
};

}  // namespace

Console& Console::instance() {
  static Console console;
  return console;
}

Console::Console() : rewrites_(isatty(STDERR_FILENO) != 0) {}

void Console::message(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (!status_.empty()) std::fputs(kEraseLine, stderr);
  std::fprintf(stderr, "%s\n", line.c_str());
  draw();
}

void Console::status(const std::string& line) {
  if (!rewrites_) return;
  const std::lock_guard lock(mutex_);
  if (line.empty() && !status_.empty()) std::fputs(kEraseLine, stderr);
  status_ = line.substr(0, terminal_width() - 1);  // a line that wraps cannot be erased
  draw();
}

void Console::draw() const {
  if (!status_.empty()) std::fprintf(stderr, "%s%s", kEraseLine, status_.c_str());
  std::fflush(stderr);
}

void set_up_logging(const std::string& level) {
  const auto logger = std::make_shared<spdlog::logger>("xgm", std::make_shared<ConsoleSink>());
  logger->set_pattern("%l: %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(logger);
}

bool shows_info() { return spdlog::should_log(spdlog::level::info); }

void log_debug(const std::string& text) { spdlog::debug(text); }
void log_info(const std::string& text) { spdlog::info(text); }
void log_warning(const std::string& text) { spdlog::warn(text); }
void log_error(const std::string& text) { spdlog::error(text); }

}  // namespace xgm::cli
