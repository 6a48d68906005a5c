// SPDX-License-Identifier: Apache-2.0
#include "options/values.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "xgm/base/error.hpp"

namespace xgm::cli {
namespace {

constexpr int kLargestDisparity = 1'000'000;

template <class Number>
std::optional<Number> parse(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<int> parse_disparity(std::string_view text) {
  const auto number = parse_whole(text);
  if (number && (*number < -kLargestDisparity || *number > kLargestDisparity)) return std::nullopt;
  return number;
}

}  // namespace

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string item = text.substr(begin, end - begin);
    item.erase(item.find_last_not_of(" \t") + 1);
    item.erase(0, std::min(item.find_first_not_of(" \t"), item.size()));
    items.push_back(std::move(item));
    begin = end + 1;
  }
  return items;
}

std::optional<double> parse_number(std::string_view text) {
  const auto number = parse<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<int> parse_whole(std::string_view text) { return parse<int>(text); }

std::vector<double> parse_no_data(const std::string& text, const std::string& option) {
  std::vector<double> values;
  if (text.empty()) return values;
  for (const std::string& item : split_at_commas(text)) {
    const std::optional<double> value = parse_number(item);
    if (!value) {
      throw UsageError(option + " " + text +
                       ": write numbers, for example -9999 or 0,65535 (NaN never is data)");
    }
    values.push_back(*value);
  }
  return values;
}

Interval parse_disparities(const std::string& text, const std::string& option) {
  const std::size_t colon = text.find(':');
  const auto first = parse_disparity(std::string_view(text).substr(0, colon));
  const auto last = colon == std::string::npos
                        ? std::nullopt
                        : parse_disparity(std::string_view(text).substr(colon + 1));
  if (!first || !last) {
    throw UsageError(option + " " + text + ": write MIN:MAX in whole px, for example 0:63");
  }
  if (*first > *last) {
    throw UsageError(option + " " + text + ": the smallest comes first; did you mean " +
                     std::to_string(*last) + ":" + std::to_string(*first) + "?");
  }
  return {*first, *last + 1};
}

double parse_bytes(const std::string& text, const std::string& option) {
  static const std::map<std::string, double> units{{"b", 1},       {"k", 1e3},     {"m", 1e6},
                                                   {"g", 1e9},     {"t", 1e12},    {"ki", 0x1p10},
                                                   {"mi", 0x1p20}, {"gi", 0x1p30}, {"ti", 0x1p40}};
  const std::size_t end = text.find_last_of("0123456789.") + 1;  // npos + 1 is 0
  std::string unit = text.substr(std::min(text.find_first_not_of(' ', end), text.size()));
  std::ranges::transform(unit, unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (unit.size() > 1 && unit.back() == 'b') unit.pop_back();  // "2G" is 2GB
  const auto number = parse_number(std::string_view(text).substr(0, end));
  const auto factor = units.find(unit);
  const double bytes = number && factor != units.end() ? *number * factor->second : 0;
  if (!(bytes > 0) || !std::isfinite(bytes)) {
    throw UsageError(option + " " + text +
                     ": write a number with a unit, for example 800MB, 2.5GB");
  }
  return bytes;
}

std::optional<cv::Size> parse_tiles(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::size_t by = std::min(text.find('x'), text.size());
  const auto width = parse_whole(std::string_view(text).substr(0, by));
  const auto height =
      by < text.size() ? parse_whole(std::string_view(text).substr(by + 1)) : std::optional<int>();
  constexpr int kSmallest = 64;
  if (!width || !height || *width < kSmallest || *height < kSmallest) {
    throw UsageError("--tiles " + text + ": write auto, or WIDTHxHEIGHT in px, each at least " +
                     std::to_string(kSmallest) + ", for example 2000x2000");
  }
  return cv::Size(*width, *height);
}

}  // namespace xgm::cli
