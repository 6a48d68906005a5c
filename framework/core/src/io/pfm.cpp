// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/pfm.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "io/pfm_in_parts.hpp"
#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int kMaxSide = 1 << 20;

struct Header {
  int channels = 1;
  int width = 0;
  int height = 0;
  bool big_endian = false;
  std::size_t scale_end = 0;  // white space follows, then the pixels
};

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The next word of the header; moves `position` behind it. Empty if there is none.
std::string_view next_word(std::string_view bytes, std::size_t& position) {
  constexpr std::size_t kLongestWord = 64;  // what is longer is no header
  while (position < bytes.size() && is_space(bytes[position])) ++position;
  std::size_t end = position;
  while (end < bytes.size() && !is_space(bytes[end]) && end - position < kLongestWord) ++end;
  const std::string_view word = bytes.substr(position, end - position);
  position = end;
  return word;
}

Header parse_header(std::string_view bytes, const std::string& file) {
  Header header;
  std::size_t at = 0;
  const std::string_view magic = next_word(bytes, at);
  if (magic != "Pf" && magic != "PF") throw Error(file + ": is no PFM file; expected Pf or PF");
  header.channels = magic == "PF" ? 3 : 1;
  const auto width = to_number<int>(std::string(next_word(bytes, at)));
  const auto height = to_number<int>(std::string(next_word(bytes, at)));
  const auto scale = to_number<double>(std::string(next_word(bytes, at)));
  const auto is_side = [](std::optional<int> side) {
    return side && *side >= 1 && *side <= kMaxSide;
  };
  if (!is_side(width) || !is_side(height) || !scale || !std::isfinite(*scale) || *scale == 0) {
    throw Error(file + ": has a broken PFM header; expected width, height and a scale");
  }
  header.width = *width;
  header.height = *height;
  header.scale_end = at;
  header.big_endian = *scale > 0;
  return header;
}

/// Whether this may stand between scale and pixels: one white space, or blanks and a line end, as
/// some programs write it. No more, as pixels may look like white space, too.
bool ends_header(std::string_view between) {
  if (between.size() == 1) return is_space(between.front());
  const std::size_t blanks = std::min(between.find_first_not_of(" \t"), between.size());
  between.remove_prefix(blanks);
  return between == "\n" || between == "\r\n";
}

/// Where the pixels begin: they are the last bytes of the file.
std::size_t pixels_begin(std::string_view bytes, const Header& header, std::size_t pixel_bytes,
                         const std::string& file) {
  const std::size_t shortest = header.scale_end + 1;
  if (bytes.size() >= shortest + pixel_bytes) {
    const std::size_t begin = bytes.size() - pixel_bytes;
    if (ends_header(bytes.substr(header.scale_end, begin - header.scale_end))) return begin;
  }
  require_length(file, bytes.size(), shortest + pixel_bytes);
  throw Error(file + ": has a broken PFM header; expected one white space behind the scale");
}

float load_float(const char* bytes, bool big_endian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  if (big_endian != (std::endian::native == std::endian::big)) bits = __builtin_bswap32(bits);
  const float value = std::bit_cast<float>(bits);
  return std::isfinite(value) ? value : kNone;
}

}  // namespace

std::vector<cv::Mat1f> read_pfm_planes(const std::string& file) {
  const std::string bytes = read_file(file);
  const Header header = parse_header(bytes, file);
  const auto width = static_cast<std::size_t>(header.width);
  const auto channels = static_cast<std::size_t>(header.channels);
  const std::size_t row_bytes = width * channels * sizeof(float);
  const std::size_t begin =  // compared with the length before anything is allocated
      pixels_begin(bytes, header, row_bytes * static_cast<std::size_t>(header.height), file);
  std::vector<cv::Mat1f> planes(channels);
  for (cv::Mat1f& plane : planes) plane.create(header.height, header.width);
  for (int y = 0; y < header.height; ++y) {
    const char* row =
        bytes.data() + begin + row_bytes * static_cast<std::size_t>(header.height - 1 - y);
    for (std::size_t c = 0; c < channels; ++c) {
      float* out = planes[channels - 1 - c][y];  // red is stored first and kept last
      for (std::size_t x = 0; x < width; ++x) {
        out[x] = load_float(row + (x * channels + c) * sizeof(float), header.big_endian);
      }
    }
  }
  return planes;
}

cv::Mat1f read_pfm(const std::string& file) {
  std::vector<cv::Mat1f> planes = read_pfm_planes(file);
  if (planes.size() != 1) {
    throw Error(file + ": has three channels; a map has one (Pf)");
  }
  return planes.front();
}

void write_pfm(const std::string& file, const cv::Mat1f& map) {
  PfmInParts pfm(file, map.size());
  pfm.put({{}, map.size()}, map);
  pfm.finish();
}

}  // namespace xgm
