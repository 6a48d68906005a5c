// SPDX-License-Identifier: Apache-2.0
// The program's arguments, and the subcommand that they call.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line/command.hpp"

namespace xgm::cli {

inline constexpr int kOk = 0;
inline constexpr int kFailed = 1;       ///< the run failed, or its map is empty
inline constexpr int kUsage = 2;        ///< usage or configuration; no image has been opened
inline constexpr int kSignalled = 128;  ///< the signal's number is added, as shells do

class CommandLine {
 public:
  CommandLine(int argc, char** argv);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// A subcommand that is followed by one of its own ("tiles plan").
  void add_group(const std::string& name, const std::string& help);

  /// Adds a subcommand, that of a group as "GROUP NAME"; `body` does its work and returns the exit
  /// code.
  Command add(const std::string& name, const std::string& help, std::function<int()> body);

  /// Without the program's name.
  const std::vector<std::string>& arguments() const { return arguments_; }

  /// Parses, and does the work of the subcommand that was called; what that throws, it throws. What
  /// is wrong with the arguments is told on stderr. Returns the exit code.
  int run();

 private:
  void require_known_names() const;

  std::vector<std::string> arguments_;
  std::unique_ptr<CLI::App> app_;
  int exit_code_ = kOk;
};

}  // namespace xgm::cli
