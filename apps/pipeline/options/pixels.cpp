// SPDX-License-Identifier: Apache-2.0
#include "options/pixels.hpp"

#include <optional>

#include "options/values.hpp"
#include "xgm/base/error.hpp"

namespace xgm::cli {
namespace {

/// A whole number from 0 on, and nothing else.
std::optional<int> parse_count(const std::string& text) {
  const auto number = parse_whole(text);
  return number && *number >= 0 ? number : std::nullopt;
}

}  // namespace

cv::Point parse_pixel(const std::string& x, const std::string& y) {
  const auto column = parse_count(x), row = parse_count(y);
  if (!column || !row) {
    throw UsageError("'" + x + " " + y +
                     "' is no pixel: give column and row as whole numbers from 0 on, for example "
                     "320 200");
  }
  return {*column, *row};
}

ExplainPixels parse_explain(const std::vector<std::string>& texts) {
  ExplainPixels wanted;
  for (const std::string& text : texts) {
    if (text.starts_with("every=")) {
      const auto step = parse_count(text.substr(6));
      if (!step || *step == 0) {
        throw UsageError("--explain " + text +
                         ": write every=N with N in px, for example every=50");
      }
      wanted.every = *step;
      continue;
    }
    const std::size_t comma = text.find(',');
    const auto x = parse_count(text.substr(0, comma));
    const auto y = comma == std::string::npos ? std::nullopt : parse_count(text.substr(comma + 1));
    if (!x || !y) {
      throw UsageError("--explain " + text +
                       ": write a pixel X,Y, for example 320,200, or every=N for a grid");
    }
    wanted.pixels.emplace_back(*x, *y);
  }
  return wanted;
}

}  // namespace xgm::cli
