// SPDX-License-Identifier: Apache-2.0
// A file that nobody sees before it is complete.
#pragma once

#include <string>

namespace xgm {

/// Throws Error: the file cannot be written, because of `error` (errno).
[[noreturn]] void throw_unwritable(const std::string& file, int error);

/// Takes bytes until it is published under its name, in one step. Where the file system can do it,
/// the file has no name before: whatever ends the process, no part of it is left.
class UnfinishedFile {
 public:
  /// Throws Error if none can be made in the folder of `target`, or if `target` is there and is
  /// no file that could be replaced.
  explicit UnfinishedFile(const std::string& target);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  /// Where to write the bytes.
  const std::string& path() const { return path_; }
  /// Replaces what is there under the target's name. Throws Error.
  void publish();

 private:
  std::string target_;
  std::string hidden_;  ///< a name in the same folder that nobody else uses
  std::string path_;    ///< `hidden_`, or that of a file without name
  int file_ = -1;       ///< without name; -1: it has one
};

}  // namespace xgm
