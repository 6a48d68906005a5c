// SPDX-License-Identifier: Apache-2.0
#include "io/possible_size.hpp"

#include <filesystem>

#include "io/image_formats.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

// Of PNG, JPEG and most TIFF one byte becomes 1032 at most. An image of one colour can do better in
// a few codecs (zstd: 32768), and is no reason to refuse a file before it is large.
constexpr std::uint64_t kMostOfOneByte = 1 << 15;
constexpr std::uint64_t kLarge = 1 << 28;

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
  const std::optional<std::uint64_t> bytes = stated_bytes(head);
  if (!bytes) throw no_image(file);
  require_possible_size(file, *bytes);
}

}  // namespace xgm
