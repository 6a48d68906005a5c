// SPDX-License-Identifier: Apache-2.0
#include "fuzz/support/memory_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include "fuzz/support/target.hpp"

namespace xgm::fuzz {

MemoryFile::MemoryFile()
    : file_(::memfd_create("fuzzed", MFD_CLOEXEC)),
      path_("/proc/self/fd/" + std::to_string(file_)) {
  require(file_ >= 0, "the system has files in memory");
}

MemoryFile::~MemoryFile() { ::close(file_); }

const std::string& MemoryFile::hold(std::string_view bytes) {
  const bool written =
      ::ftruncate(file_, 0) == 0 &&
      ::pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
  require(written, "a file in memory takes the input");
  return path_;
}

}  // namespace xgm::fuzz
