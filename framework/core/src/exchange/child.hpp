// SPDX-License-Identifier: Apache-2.0
// A child process that leads a group of its own, so that all that it starts can be ended with it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace xgm::exchange {

class Child {
 public:
  /// Starts words[0], looked for in PATH unless it has a slash, with all words as its arguments.
  /// Throws Error if there is no such program, or it cannot be started. `memory_bytes`: bound of
  /// the address space; 0: none.
  Child(std::vector<std::string> words, double memory_bytes);
  /// Ends what is left of the group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits up to some hundredths of a second for what it prints. Empty if that is nothing yet, or
  /// nothing more.
  std::string read() const;
  /// Whether the child itself has ended; others of its group may live on.
  bool has_ended() const;
  /// Asks the group to end, and ends it soon afterwards.
  void end();
  /// Its wait status, once it has ended; also ends what is left of its group.
  int status();

 private:
  pid_t id_ = -1;  ///< -1: it has been waited for
  int output_ = -1;
};

}  // namespace xgm::exchange
