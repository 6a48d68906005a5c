// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/memory.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace xgm {
namespace {

constexpr std::uint64_t kUnknown = UINT64_MAX;

/// The number behind `key` in a file of lines "key number ...".
std::optional<std::uint64_t> number_behind(const std::string& file, const std::string& key) {
  std::ifstream stream(file);
  std::string word;
  while (stream >> word) {
    std::uint64_t number = 0;
    if (word == key && stream >> number) return number;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> first_number(const std::string& file) {
  std::ifstream stream(file);
  std::uint64_t number = 0;
  if (stream >> number) return number;
  return std::nullopt;  // no such file, or "max"
}

/// What the control groups (version 2) of this process leave: the least of its own and all above.
std::uint64_t left_by_control_groups() {
  std::ifstream stream("/proc/self/cgroup");
  std::string line, path;
  while (std::getline(stream, line)) {
    if (line.starts_with("0::")) path = line.substr(3);
  }
  std::uint64_t minimum = kUnknown;
  for (std::filesystem::path group(path); !path.empty(); group = group.parent_path()) {
    const std::string folder = "/sys/fs/cgroup" + group.string();
    const auto limit = first_number(folder + "/memory.max");
    // File pages are given back when memory runs short; what was asked for is not.
    const auto held = number_behind(folder + "/memory.stat", "anon");
    if (limit && held) minimum = std::min(minimum, *limit > *held ? *limit - *held : 0);
    if (group == group.parent_path()) break;
  }
  return minimum;
}

}  // namespace

std::uint64_t peak_memory() {
  // getrusage's figure includes what the process that started this one had in use.
  if (const auto peak_kib = number_behind("/proc/self/status", "VmHWM:")) return *peak_kib * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::uint64_t resident_memory() {
  return number_behind("/proc/self/status", "VmRSS:").value_or(0) * 1024;
}

std::uint64_t program_memory() {
  return number_behind("/proc/self/status", "RssFile:").value_or(0) * 1024;
}

std::uint64_t available_memory() {
  const auto free_kib = number_behind("/proc/meminfo", "MemAvailable:");
  return std::min(free_kib ? *free_kib * 1024 : kUnknown, left_by_control_groups());
}

void trim_heap() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void limit_memory(std::uint64_t bytes) {
  const auto held_kib = number_behind("/proc/self/status", "VmData:");
  if (bytes == kUnknown || !held_kib) return;
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, *held_kib * 1024 + bytes);
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace xgm
