// SPDX-License-Identifier: Apache-2.0
#include "io/image_formats.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "xgm/base/scalar.hpp"

namespace xgm {
namespace {

using namespace std::string_view_literals;

/// Reads fields of a header; 0 behind its end.
class Header {
 public:
  explicit Header(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t big(std::size_t at, std::size_t length) const {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + length; ++i) value = value << 8 | byte(i);
    return value;
  }
  std::uint64_t little(std::size_t at, std::size_t length) const {
    std::uint64_t value = 0;
    for (std::size_t i = at + length; i > at; --i) value = value << 8 | byte(i - 1);
    return value;
  }
  std::int64_t little_signed(std::size_t at) const {
    return static_cast<std::int32_t>(little(at, 4));
  }
  /// The whole number of a text that follows `name`.
  std::uint64_t number_behind(std::string_view name) const {
    const std::size_t begin = behind(name);
    const std::size_t end = std::min(bytes_.find_first_not_of("0123456789", begin), bytes_.size());
    return to_number<std::uint32_t>(std::string(bytes_.substr(begin, end - begin))).value_or(0);
  }
  /// Where the bytes end that look like this; the end of all if there are none.
  std::size_t behind(std::string_view bytes) const {
    const std::size_t at = bytes_.find(bytes);
    return at == std::string_view::npos ? bytes_.size() : at + bytes.size();
  }

 private:
  std::uint64_t byte(std::size_t at) const {
    return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0;
  }

  std::string_view bytes_;
};

/// Does not overflow: no format has a longer side that OpenCV would read.
std::uint64_t area(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kLongest = 1 << 24;
  return std::min(width, kLongest) * std::min(height, kLongest);
}

std::uint64_t looked_at_before(const Header&) { return 0; }

std::uint64_t png(const Header& header) {
  constexpr std::uint64_t kGrey = 0;
  const std::uint64_t samples = header.big(25, 1) == kGrey ? 1 : 4;
  return area(header.big(16, 4), header.big(20, 4)) * samples * (header.big(24, 1) == 16 ? 2 : 1);
}

std::uint64_t bmp(const Header& header) {
  const auto side = [&](std::size_t at) {  // negative heights are of images that begin at the top
    return static_cast<std::uint64_t>(std::abs(header.little_signed(at)));
  };
  return area(side(18), side(22)) * (header.little(28, 2) <= 24 ? 3 : 4);
}

/// The three kinds of first chunk: lossy, lossless, extended.
std::uint64_t webp(const Header& header) {
  constexpr std::uint64_t kSide = (1 << 14) - 1, kSamples = 4;
  const std::uint64_t kind = header.big(15, 1);
  if (kind == ' ') {
    return area(header.little(26, 2) & kSide, header.little(28, 2) & kSide) * kSamples;
  }
  if (kind == 'L') {
    const std::uint64_t sides = header.little(21, 4);
    return area((sides & kSide) + 1, (sides >> 14 & kSide) + 1) * kSamples;
  }
  return area(header.little(24, 3) + 1, header.little(27, 3) + 1) * kSamples;
}

/// The codestream begins with its size, within a file or alone.
std::uint64_t jpeg_2000(const Header& header) {
  constexpr std::uint64_t kSamples = 4, kBytes = 4;  // as the decoder holds them
  const std::size_t size = header.behind("\xff\x4f\xff\x51"sv) + 4;
  return area(header.big(size, 4), header.big(size + 4, 4)) * kSamples * kBytes;
}

std::uint64_t sun_raster(const Header& header) {
  return area(header.big(4, 4), header.big(8, 4)) * 4;
}

std::uint64_t radiance(const Header& header) {
  constexpr std::uint64_t kSamples = 3;
  return area(header.number_behind("+X "), header.number_behind("-Y ")) * kSamples * sizeof(float);
}

std::uint64_t exr(const Header& header) {
  constexpr std::uint64_t kSamples = 4;
  const std::size_t box = header.behind("dataWindow\0box2i\0"sv) + 4;
  const auto side = [&](std::size_t low) {
    const std::int64_t length = header.little_signed(low + 8) - header.little_signed(low) + 1;
    return static_cast<std::uint64_t>(std::max<std::int64_t>(length, 0));
  };
  return area(side(box), side(box + 4)) * kSamples * sizeof(float);
}

struct Format {
  std::string_view begin;
  std::uint64_t (*bytes)(const Header&);
};

constexpr std::array kFormats{
    Format{"\x89PNG\r\n\x1a\n"sv, png},
    Format{"\xff\xd8\xff"sv, looked_at_before},
    Format{"BM"sv, bmp},
    Format{"RIFF"sv, webp},
    Format{"\0\0\0\x0cjP  \r\n\x87\n"sv, jpeg_2000},
    Format{"\xff\x4f\xff\x51"sv, jpeg_2000},
    Format{"\x59\xa6\x6a\x95"sv, sun_raster},
    Format{"#?RADIANCE"sv, radiance},
    Format{"#?RGBE"sv, radiance},
    Format{"\x76\x2f\x31\x01"sv, exr},
};

}  // namespace

bool is_pnm(std::string_view head) {
  return head.size() >= 3 && head[0] == 'P' && head[1] >= '1' && head[1] <= '7' &&
         " \t\r\n#"sv.find(head[2]) != std::string_view::npos;
}

std::optional<std::uint64_t> stated_bytes(std::string_view head) {
  for (const Format& format : kFormats) {
    if (head.starts_with(format.begin)) return format.bytes(Header(head));
  }
  if (is_pnm(head)) return 0;
  return std::nullopt;
}

Error no_image(const std::string& file) {
  return Error(file +
               ": is no image that can be read; give a complete PNG, TIFF, JPEG, PNM or PFM");
}

}  // namespace xgm
