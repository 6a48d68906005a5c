// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/pfm.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string_view>

#include "xgm/base/error.hpp"
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
  std::size_t end = 0;  // where the pixels begin
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

template <class Number>
bool parse(std::string_view word, Number& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
  return failure == std::errc() && end == word.data() + word.size();
}

Header parse_header(std::string_view bytes, const std::string& file) {
  Header header;
  std::size_t at = 0;
  const std::string_view magic = next_word(bytes, at);
  if (magic != "Pf" && magic != "PF") throw Error(file + ": is no PFM file; expected Pf or PF");
  header.channels = magic == "PF" ? 3 : 1;
  double scale = 0;
  const bool good = parse(next_word(bytes, at), header.width) &&
                    parse(next_word(bytes, at), header.height) &&
                    parse(next_word(bytes, at), scale) && std::isfinite(scale) && scale != 0;
  if (!good || header.width < 1 || header.height < 1 || header.width > kMaxSide ||
      header.height > kMaxSide) {
    throw Error(file + ": has a broken PFM header; expected width, height and a scale");
  }
  if (at < bytes.size() && bytes[at] == '\r' && at + 1 < bytes.size() && bytes[at + 1] == '\n')
    ++at;
  header.end = at + 1;  // exactly one white space ends the header: pixels may look like more of it
  header.big_endian = scale > 0;
  return header;
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
  const std::size_t needed = header.end + row_bytes * static_cast<std::size_t>(header.height);
  if (bytes.size() < needed) {  // compared before anything is allocated
    throw Error(file + ": is cut short: " + std::to_string(bytes.size()) + " of " +
                std::to_string(needed) + " bytes; copy it again");
  }
  std::vector<cv::Mat1f> planes(channels);
  for (cv::Mat1f& plane : planes) plane.create(header.height, header.width);
  for (int y = 0; y < header.height; ++y) {
    const char* row =
        bytes.data() + header.end + row_bytes * static_cast<std::size_t>(header.height - 1 - y);
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
  write_file(file, [&](std::ostream& stream) {
    constexpr bool kBig = std::endian::native == std::endian::big;
    stream << "Pf\n" << map.cols << ' ' << map.rows << '\n' << (kBig ? "1.0\n" : "-1.0\n");
    std::vector<float> row(static_cast<std::size_t>(map.cols));
    for (int y = map.rows - 1; y >= 0; --y) {
      for (int x = 0; x < map.cols; ++x) {
        const float value = map(y, x);
        row[static_cast<std::size_t>(x)] =
            std::isfinite(value) ? value : std::numeric_limits<float>::infinity();
      }
      stream.write(reinterpret_cast<const char*>(row.data()),
                   static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
  });
}

}  // namespace xgm
