// SPDX-License-Identifier: Apache-2.0
#include "io/unfinished_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/replaceable.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr int kMode = 0666;  // as far as the user's mask allows

std::string hidden_name(const fs::path& folder) {
  static std::atomic<unsigned> count{0};
  return (folder / (".xgm." + std::to_string(::getpid()) + "." + std::to_string(count++) + ".part"))
      .string();
}

}  // namespace

void throw_unwritable(const std::string& file, int error) {
  throw Error(file + ": cannot be written: " + std::strerror(error) +
              "; check the folder, its permissions and the free space");
}

UnfinishedFile::UnfinishedFile(const std::string& target) : target_(target) {
  const std::string objection = objection_to_replacing(target);
  if (!objection.empty()) throw Error(target + ": cannot be written: " + objection);
  const fs::path parent = fs::path(target).parent_path();
  const fs::path folder = parent.empty() ? "." : parent;
  hidden_ = hidden_name(folder);
  ::unlink(hidden_.c_str());  // left by a process of the same number that was killed
  file_ = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  path_ = "/proc/self/fd/" + std::to_string(file_);
  if (file_ >= 0 && ::access(path_.c_str(), F_OK) == 0) return;
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  path_ = hidden_;
  const int named = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
  if (named < 0) throw_unwritable(target, errno);
  ::close(named);
}

UnfinishedFile::~UnfinishedFile() {
  if (file_ >= 0) ::close(file_);
  ::unlink(hidden_.c_str());  // nothing is there once it is published
}

void UnfinishedFile::publish() {
  const auto link = [&](const std::string& name) {
    return ::linkat(AT_FDCWD, path_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (file_ >= 0) {
    if (link(target_)) return;
    if (errno != EEXIST || !link(hidden_))
      throw_unwritable(target_, errno);  // only a rename replaces a file
  }
  if (::rename(hidden_.c_str(), target_.c_str()) != 0) throw_unwritable(target_, errno);
}

}  // namespace xgm
