// SPDX-License-Identifier: Apache-2.0
// The terminal: messages (stderr), and below them one line that is rewritten.
#pragma once

#include <mutex>
#include <string>

namespace xgm::cli {

/// Safe to use from several threads. There is one terminal, hence one object.
class Console {
 public:
  static Console& instance();

  /// Whether stderr is a terminal, so that a line can be rewritten.
  bool rewrites() const { return rewrites_; }
  /// Prints a line to stderr; the line being rewritten moves below it.
  void message(const std::string& line);
  /// Replaces the line that is rewritten (an empty one removes it). Does nothing elsewhere than on
  /// a terminal.
  void status(const std::string& line);

 private:
  Console();
  void draw() const;

  std::mutex mutex_;
  std::string status_;
  bool rewrites_;
};

/// Which messages are shown: debug, info, warning or error.
void set_up_logging(const std::string& level);
bool shows_info();

/// A message of that level, through the console.
void log_debug(const std::string& text);
void log_info(const std::string& text);
void log_warning(const std::string& text);
void log_error(const std::string& text);

}  // namespace xgm::cli
