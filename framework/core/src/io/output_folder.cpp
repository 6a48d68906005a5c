// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "io/unfinished_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;

void make_output_folder(const std::string& folder, const std::string& what) {
  std::error_code failure, unusable;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, unusable)) {
    throw UsageError(what + folder + ": cannot be made a folder: " +
                     (failure ? failure.message() : "it is a file") + "; choose another one");
  }
  require_writable(folder, what);
}

OutputFolder::OutputFolder(const std::string& folder, const std::string& what) {
  std::error_code unusable;
  for (fs::path path = fs::absolute(folder); !path.empty() && !fs::exists(path, unusable);
       path = path.parent_path()) {
    if (path.has_filename()) made_.push_back(path.string());  // "a/" is "a", once
  }
  make_output_folder(folder, what);
}

OutputFolder::~OutputFolder() {
  for (const std::string& folder : made_) {
    if (::rmdir(folder.c_str()) != 0) break;  // something is in it
  }
}

void require_writable(const std::string& folder, const std::string& what) {
  try {
    const UnfinishedFile trial((fs::path(folder) / ".writable").string());
  } catch (const Error& error) {
    throw UsageError(what + error.message());
  }
}

FolderLock::FolderLock(const std::string& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0 || ::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(folder_);
  throw UsageError("another run or bench writes to " + folder +
                   "; wait for it, or give another --output");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

}  // namespace xgm
