// SPDX-License-Identifier: Apache-2.0
#include "io/possible_size.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

// Of PNG, JPEG and most TIFF one byte becomes 1032 at most. An image of one colour can do better in
// a few codecs (zstd: 32768), and is no reason to refuse a file before it is large.
constexpr std::uint64_t kMostOfOneByte = 1 << 15;
constexpr std::uint64_t kLarge = 1 << 28;

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::uint64_t little_endian(std::string bytes) {
  std::reverse(bytes.begin(), bytes.end());
  return big_endian(bytes);
}

std::uint64_t png_bytes(const std::string& head) {
  constexpr char kGrey = 0;
  const std::uint64_t samples = head[25] == kGrey ? 1 : 4, bytes = head[24] == 16 ? 2 : 1;
  return big_endian(head.substr(16, 4)) * big_endian(head.substr(20, 4)) * samples * bytes;
}

std::uint64_t bmp_bytes(const std::string& head) {
  const auto side = [&](std::size_t at) {  // negative heights are of images that begin at the top
    const auto value = static_cast<std::int32_t>(little_endian(head.substr(at, 4)));
    return static_cast<std::uint64_t>(std::abs(std::int64_t{value}));
  };
  return side(18) * side(22) * (little_endian(head.substr(28, 2)) <= 24 ? 3 : 4);
}

}  // namespace

bool is_possible_size(std::uint64_t file_bytes, std::uint64_t image_bytes) {
  return image_bytes <= kLarge || image_bytes / kMostOfOneByte <= file_bytes;
}

void require_possible_size(const std::string& file, std::uint64_t image_bytes) {
  const std::uint64_t file_bytes = std::filesystem::file_size(file);
  if (is_possible_size(file_bytes, image_bytes)) return;
  throw Error(file + ": has a broken header: it speaks of " + std::to_string(image_bytes) +
              " bytes of pixels, and " + std::to_string(file_bytes) +
              " bytes of a file cannot hold them; copy it again");
}

void require_possible_header(const std::string& file, const std::string& head) {
  if (head.size() < kSizeHeader) return;
  if (head.starts_with("\x89PNG")) require_possible_size(file, png_bytes(head));
  if (head.starts_with("BM")) require_possible_size(file, bmp_bytes(head));
}

}  // namespace xgm
