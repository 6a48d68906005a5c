// SPDX-License-Identifier: Apache-2.0
// Where results will go: tried before anything is computed that could not be kept.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// Makes the folder if it is missing. Throws UsageError if it cannot be made or written to; the
/// message begins with `what` ("--output ").
XGM_API void make_output_folder(const std::string& folder, const std::string& what = {});

/// Throws UsageError if no file can be written to the folder ("" is the current one); the message
/// begins with `what`.
XGM_API void require_writable(const std::string& folder, const std::string& what = {});

/// Keeps other runs and benches out of a folder for as long as it exists, so that what the folder
/// holds is of one of them. It ends with its process, however that ends, and leaves nothing in the
/// folder. A file system without locks gives no protection.
class XGM_API FolderLock {
 public:
  /// Throws UsageError if somebody else has the folder.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether no other run can have the folder; not so on file systems that know no locks.
  bool is_held() const { return is_held_; }
  /// Whether the path still leads to the folder that was locked.
  bool is_at(const std::string& folder) const;

 private:
  int folder_ = -1;
  bool is_held_ = false, is_missing_ = false;
};

/// A folder that belongs to one run as long as this exists. It is made if it is missing, with those
/// above it, and taken away again at the end if nothing has come into it.
class XGM_API OutputFolder {
 public:
  /// Throws what make_output_folder() and FolderLock throw; then nothing is taken away.
  explicit OutputFolder(const std::string& folder, const std::string& what = {});
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::vector<std::string> made_;  ///< the innermost first
  std::optional<FolderLock> lock_;
};

}  // namespace xgm
