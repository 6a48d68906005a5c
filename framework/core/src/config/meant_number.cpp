// SPDX-License-Identifier: Apache-2.0
#include "config/meant_number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "xgm/base/file_names.hpp"
#include "xgm/base/scalar.hpp"

namespace xgm {
namespace {

std::optional<double> whole_number(std::string_view digits, int base) {
  std::uint32_t value = 0;
  const auto [end, failure] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  const bool is_all = failure == std::errc() && end == digits.data() + digits.size();
  return is_all ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

std::optional<double> meant_number(const std::string& text) {
  std::string number = lower_case(text);
  std::erase(number, '_');
  constexpr struct {
    const char* prefix;
    int base;
  } kBases[] = {{"0x", 16}, {"0o", 8}, {"0b", 2}};
  for (const auto& [prefix, base] : kBases) {
    if (number.starts_with(prefix)) return whole_number(std::string_view(number).substr(2), base);
  }
  std::replace(number.begin(), number.end(), ',', '.');
  return to_number<double>(number);
}

}  // namespace xgm
