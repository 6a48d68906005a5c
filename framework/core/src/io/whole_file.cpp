// SPDX-License-Identifier: Apache-2.0
#include "io/whole_file.hpp"

#include <filesystem>
#include <fstream>

#include "io/image_formats.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

std::uint64_t big_endian(const std::string& bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace

void require_whole(const std::string& file, const std::string& head) {
  if (head.starts_with("\xff\xd8\xff")) return require_whole_jpeg(file);
  if (head.starts_with("\x89PNG")) return require_whole_png(file);
  if (is_pnm(head)) return require_whole_pnm(file);
}

void require_length(const std::string& file, std::uint64_t bytes, std::uint64_t needed) {
  const std::string of = std::to_string(bytes) + " of " + std::to_string(needed) + " bytes";
  if (bytes < needed) throw Error(file + ": is cut short: " + of + "; copy it again");
  if (bytes > needed) {
    throw Error(file + ": is longer than its header says: " + of +
                ", as after a copy that changed line ends; copy it again, as binary");
  }
}

/// Chunks follow each other, each with its length, until IEND.
void require_whole_png(const std::string& file) {
  constexpr std::uint64_t kSignature = 8, kLength = 4, kType = 4, kChecksum = 4;
  const std::uint64_t size = std::filesystem::file_size(file);
  std::ifstream stream(file, std::ios::binary);
  std::uint64_t at = kSignature;
  for (std::string type; type != "IEND";) {
    std::string head(kLength + kType, '\0');
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    at += head.size() + (stream ? big_endian(head.substr(0, kLength)) : 0) + kChecksum;
    if (at > size) require_length(file, size, at);
    type = head.substr(kLength);
  }
}

}  // namespace xgm
