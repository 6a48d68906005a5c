// SPDX-License-Identifier: Apache-2.0
// Where results will go: tried before anything is computed that could not be kept.
#pragma once

#include <string>

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

 private:
  int folder_ = -1;
};

}  // namespace xgm
