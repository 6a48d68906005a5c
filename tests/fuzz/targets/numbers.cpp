// SPDX-License-Identifier: Apache-2.0
// Numbers as the command line takes them, each kind with the same text.
#include <cmath>

#include "fuzz/support/target.hpp"
#include "options/pixels.hpp"
#include "options/thresholds.hpp"
#include "options/values.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm::fuzz {
namespace {

void check_numbers(const std::string& text) {
  if (const auto number = cli::parse_number(text)) {
    require(std::isfinite(*number), "a number is finite");
    require(cli::parse_number(short_number(*number)) == number, "a printed number is the number");
  }
  if (const auto whole = cli::parse_whole(text)) {
    require(cli::parse_whole(std::to_string(*whole)) == whole, "a printed number is the number");
  }
}

void check_disparities(const std::string& text) {
  Interval range;
  if (!accepts(text, [&] { range = cli::parse_disparities(text); })) return;
  require(!range.empty(), "there is a disparity to search");
  const std::string printed =
      std::to_string(range.begin) + ":" + std::to_string(std::int64_t{range.end} - 1);
  require(cli::parse_disparities(printed) == range, "a printed range is the range");
}

void check_bytes(const std::string& text) {
  double bytes = 0;
  if (!accepts(text, [&] { bytes = cli::parse_bytes(text, "--memory-limit"); })) return;
  require(std::isfinite(bytes) && bytes > 0, "a size is a number above 0");
}

void check_thresholds(const std::string& text) {
  std::vector<double> thresholds;
  if (!accepts(text, [&] { thresholds = cli::parse_thresholds(text); })) return;
  require(!thresholds.empty(), "there is a threshold");
  double last = -1;
  for (const double threshold : thresholds) {
    require(std::isfinite(threshold) && threshold > last, "thresholds rise from 0 on");
    last = std::max(threshold, 0.0);
  }
}

void check_no_data(const std::string& text) {
  std::vector<double> values;
  if (!accepts(text, [&] { values = cli::parse_no_data(text, "--nodata"); })) return;
  require(values.empty() == text.empty(), "what is given is not lost");
  for (const double value : values) require(std::isfinite(value), "a number is finite");
}

void check_pixels(const std::string& text) {
  ExplainPixels wanted;
  if (!accepts(text, [&] { wanted = cli::parse_explain({text}); })) return;
  require(!wanted.empty(), "there is a pixel");
  for (const cv::Point pixel : wanted.pixels) {
    require(pixel.x >= 0 && pixel.y >= 0, "columns and rows are counted from 0");
  }
}

void check_sweep(const std::string& text) {
  Sweep sweep;
  if (!accepts(text, [&] { sweep = parse_sweep(text); })) return;
  require(!sweep.path.empty() && !sweep.values.empty(), "a sweep has a path and a value");
  require(sweep_points({sweep}).size() == sweep.values.size(), "each value is a point");
}

}  // namespace

void check(std::string_view input) {
  const std::string text(input.substr(0, input.find('\0')));  // as arguments of programs end
  check_numbers(text);
  check_disparities(text);
  check_bytes(text);
  check_thresholds(text);
  check_no_data(text);
  check_pixels(text);
  check_sweep(text);
}

std::vector<std::string> seeds() {
  return {"0:63",
          "-64:+64",
          "2.5GB",
          "800 MB",
          "1GiB",
          "0.5,1,2,4",
          "320,200",
          "every=50",
          "1e-3",
          "+7",
          "matcher.scale=4,8",
          "a.b[0]={type: census, window: 5},[1,2],'x,y'"};
}

std::vector<std::string> words() {
  return {"e308",   "e-320",      "0x1p",    "inf", "nan", "TiB", "KiB", "kB",
          "every=", "2147483647", "1000000", ":",   ",",   "(",   "]",   "="};
}

}  // namespace xgm::fuzz
