// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "io/unfinished_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// The folder and those above it that are not there, the innermost first.
std::vector<std::string> missing_folders(const std::string& folder) {
  std::vector<std::string> missing;
  std::error_code unusable;
  for (fs::path path = fs::absolute(folder); !path.empty() && !fs::exists(path, unusable);
       path = path.parent_path()) {
    if (path.has_filename()) missing.push_back(path.string());  // "a/" is "a", once
  }
  return missing;
}

}  // namespace

void make_output_folder(const std::string& folder, const std::string& what) {
  std::error_code failure, unusable;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, unusable)) {
    throw UsageError(what + folder + ": cannot be made a folder: " +
                     (failure ? failure.message() : "it is a file") + "; choose another one");
  }
  require_writable(folder, what);
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
  is_missing_ = folder_ < 0 && errno == ENOENT;
  if (folder_ < 0) return;
  is_held_ = ::flock(folder_, LOCK_EX | LOCK_NB) == 0;
  if (is_held_ || errno != EWOULDBLOCK) return;
  ::close(folder_);
  throw UsageError("another run or bench writes to " + folder +
                   "; wait for it, or give another --output");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

bool FolderLock::is_at(const std::string& folder) const {
  struct stat locked = {}, there = {};
  if (folder_ < 0 || ::fstat(folder_, &locked) != 0) return !is_missing_;
  return ::stat(folder.c_str(), &there) == 0 && locked.st_dev == there.st_dev &&
         locked.st_ino == there.st_ino;
}

OutputFolder::OutputFolder(const std::string& folder, const std::string& what) {
  do {  // again if another run has taken its folder away between making and locking
    lock_.reset();
    made_ = missing_folders(folder);
    make_output_folder(folder, what);
    lock_.emplace(folder);
  } while (!lock_->is_at(folder));
}

OutputFolder::~OutputFolder() {
  if (!lock_->is_held()) return;  // another run may be about to write
  for (const std::string& folder : made_) {
    if (::rmdir(folder.c_str()) != 0) break;  // something is in it
  }
}

}  // namespace xgm
