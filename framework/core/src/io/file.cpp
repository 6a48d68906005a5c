// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "io/unfinished_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kFnvOffset = 14695981039346656037u;
constexpr std::uint64_t kFnvPrime = 1099511628211u;
// Two changes within it may bear the same time: file systems that count in steps of 2 s, and
// servers whose clock is not ours.
constexpr std::int64_t kCoarsestTime = 10'000'000'000;  // ns
constexpr const char* kEmpty = ": is empty; give a complete file";

std::uint64_t fnv1a64(std::uint64_t hash, std::string_view bytes) {
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * kFnvPrime;
  }
  return hash;
}

std::string digits_of(std::uint64_t hash) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::ifstream open_to_read(const std::string& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) throw Error(file + ": no such file; check the path");
  if (fs::is_directory(status)) throw Error(file + ": is a folder; give a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file + ": cannot be opened: " + std::strerror(errno));
  return stream;
}

/// Calls body(piece) for the whole content; never holds more than one piece.
template <class Body>
void read_pieces(const std::string& file, Body body) {
  std::ifstream stream = open_to_read(file);
  // A byte more than a small file has, so that its end is met with its only piece.
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(file, unknown);  // -1 for a pipe
  std::vector<char> buffer(std::clamp<std::uintmax_t>(size + 1, 4096, std::uintmax_t{1} << 20));
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    body(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad()) throw Error(file + ": reading failed: " + std::strerror(errno));
}

/// ns since 1970; 0 if it is not known.
std::int64_t modified_at(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return 0;
  return std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
}

std::int64_t nanoseconds_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

}  // namespace

std::string why_unreadable(const std::string& file) {
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (!fs::exists(status)) {
    const bool is_absent =
        failure == std::errc::no_such_file_or_directory || failure == std::errc::not_a_directory;
    if (failure && !is_absent) {
      return "cannot be opened: " + failure.message();
    }
    std::error_code ignored;
    const bool is_link = fs::is_symlink(fs::symlink_status(file, ignored));
    return is_link ? "is a link that leads nowhere" : "no such file";
  }
  if (fs::is_directory(status)) return "is a folder";
  if (::faccessat(AT_FDCWD, file.c_str(), R_OK, AT_EACCESS) != 0) {
    return std::string("cannot be opened: ") + std::strerror(errno);
  }
  return {};
}

std::string read_file(const std::string& file, std::uint64_t limit) {
  std::string bytes;
  read_pieces(file, [&](std::string_view piece) {
    if (bytes.size() + piece.size() > limit) {
      throw Error(file + ": larger than " + std::to_string(limit) +
                  " bytes, which no such file is; check the path");
    }
    bytes.append(piece);
  });
  if (bytes.empty()) throw Error(file + kEmpty);
  return bytes;
}

std::string read_head(const std::string& file, std::size_t count) {
  std::ifstream stream = open_to_read(file);
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) throw Error(file + kEmpty);
  return bytes;
}

void remove_file(const std::string& file) {
  std::error_code failure;
  fs::remove(file, failure);
  if (failure) throw Error(file + ": cannot be removed: " + failure.message());
}

void write_file(const std::string& file, const std::function<void(std::ostream&)>& write) {
  UnfinishedFile unfinished(file);
  std::ofstream stream(unfinished.path(), std::ios::binary | std::ios::trunc);
  if (stream) write(stream);
  stream.close();
  if (!stream) throw_unwritable(file, errno);
  unfinished.publish();
}

void write_file(const std::string& file, std::string_view bytes) {
  write_file(file, [&](std::ostream& stream) {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

void sync_file(const std::string& file) {
  const int number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (number < 0) throw_unwritable(file, errno);
  const int failure = ::fsync(number) == 0 ? 0 : errno;
  ::close(number);
  if (failure != 0) throw_unwritable(file, failure);
}

std::uint64_t fnv1a64(std::string_view bytes) { return fnv1a64(kFnvOffset, bytes); }

std::string hash_text(std::string_view bytes) { return digits_of(fnv1a64(bytes)); }

FileIdentity identify_file(const std::string& file) {
  FileIdentity identity;
  const std::int64_t before = modified_at(file), now = nanoseconds_now();
  std::uint64_t hash = kFnvOffset;
  read_pieces(file, [&](std::string_view piece) {
    identity.bytes += piece.size();
    hash = fnv1a64(hash, piece);
  });
  identity.fnv1a64 = digits_of(hash);
  if (now - before > kCoarsestTime && modified_at(file) == before) identity.modified = before;
  return identity;
}

bool is_still(const std::string& file, const FileIdentity& identity) {
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(file, unknown);
  if (!unknown && bytes != identity.bytes) return false;
  if (!unknown && identity.modified != 0 && modified_at(file) == identity.modified) return true;
  const FileIdentity now = identify_file(file);
  return now.bytes == identity.bytes && now.fnv1a64 == identity.fnv1a64;
}

}  // namespace xgm
