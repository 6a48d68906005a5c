// SPDX-License-Identifier: Apache-2.0
// A file that lies in memory, for readers that take a path.
#pragma once

#include <string>
#include <string_view>

namespace xgm::fuzz {

class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Replaces the content; returns the path.
  const std::string& hold(std::string_view bytes);
  const std::string& path() const { return path_; }

 private:
  int file_;
  std::string path_;
};

}  // namespace xgm::fuzz
