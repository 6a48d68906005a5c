// SPDX-License-Identifier: Apache-2.0
// Runs in processes of their own: what one does to memory, or dies of, stays its own.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process, but are noted.
class XGM_API Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  /// The signal that came; 0 if none did.
  static int signal();
};

/// While it lives, no other process has one for the same folder: it holds `folder`/.lock. Throws
/// Error if another has; a file system without locks protects nothing.
class XGM_API FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

/// Runs the file `program`, its output going to `log`, until it ends or this process is told to; it
/// does not outlive this process. `words` are its command line, the program's own name first.
/// `failure` is the last error that it printed, or how it ended.
XGM_API RunOutcome run_program(const std::string& program, const std::vector<std::string>& words,
                               const std::string& log);

}  // namespace xgm
