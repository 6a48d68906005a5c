// SPDX-License-Identifier: Apache-2.0
#include "options/values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/metrics.hpp"

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

std::optional<double> parse_number(std::string_view text) {
  const auto number = parse<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<int> parse_whole(std::string_view text) { return parse<int>(text); }

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
  static const std::map<std::string, double> units{{"B", 1},
                                                   {"kB", 1e3},
                                                   {"KB", 1e3},
                                                   {"MB", 1e6},
                                                   {"GB", 1e9},
                                                   {"TB", 1e12},
                                                   {"KiB", 1024.0},
                                                   {"MiB", 1024.0 * 1024},
                                                   {"GiB", 1024.0 * 1024 * 1024},
                                                   {"TiB", 1024.0 * 1024 * 1024 * 1024}};
  const std::size_t end = text.find_last_of("0123456789.") + 1;  // npos + 1 is 0
  const std::size_t unit = std::min(text.find_first_not_of(' ', end), text.size());
  const auto number = parse_number(std::string_view(text).substr(0, end));
  const auto factor = units.find(text.substr(unit));
  if (!number || *number <= 0 || factor == units.end()) {
    throw UsageError(option + " " + text +
                     ": write a number with a unit, for example 800MB, 2.5GB");
  }
  return *number * factor->second;
}

std::vector<double> parse_thresholds(const std::string& text) {
  if (text.empty()) return usual_thresholds();
  std::vector<double> deltas;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto delta = parse_number(std::string_view(text).substr(begin, end - begin));
    if (!delta || *delta < 0 || (!deltas.empty() && *delta <= deltas.back())) {
      throw UsageError("--thresholds " + text +
                       ": write rising numbers of px, 0 or more, for example 0.5,1,2,4");
    }
    deltas.push_back(*delta);
    begin = end + 1;
  }
  return deltas;
}

}  // namespace xgm::cli
