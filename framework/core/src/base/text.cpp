// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace xgm {

std::string short_number(double value) {
  std::array<char, 64> digits;
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-4 && size < 1e15);  // 100000, not 1e+05
  const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format).ptr;
  return {digits.data(), end};
}

std::string fixed_number(double value, int decimals) {
  std::array<char, 400> digits;  // the largest double has 309 digits
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  const std::string text(digits.data(), end);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

std::string bytes_text(double bytes) {
  return bytes < 1e9 ? fixed_number(bytes / 1e6, 0) + " MB" : fixed_number(bytes / 1e9, 2) + " GB";
}

}  // namespace xgm
